#pragma once

#include <atomic>
#include <filesystem>
#include <vector>

#include "dataset/job/records.h"
#include "production/lit_scene.h"
#include "production/view_images.h"
#include "sampler/plan/plan.h"

namespace cps {

/// What instance and semantic labels, as far as they are wanted, say of each of Scene::instances. Throws as
/// object_ids() and semantic_classes() do.
InstanceLabels instance_labels(const Scene& scene, const std::vector<DenseLabel>& wanted);

/// Computes the recipe's dense labels of a view's images, one ray a pixel through each image's lens, and
/// writes them below `root`: an entry per image, in their order. The car must be where the view has it, as
/// after render_view(). Several images are made at a time, each on one thread, whose CPU time is added to
/// `cpu_ns`. Throws std::runtime_error in one line when a file cannot be written.
std::vector<std::vector<DenseRecord>> make_dense_labels(const Recipe& recipe, const PlannedView& view,
                                                        const ViewImages& wanted, const LitScene& lit,
                                                        const std::filesystem::path& root,
                                                        std::atomic<std::int64_t>& cpu_ns);

}  // namespace cps
