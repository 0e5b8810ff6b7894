#pragma once

#include <atomic>
#include <filesystem>

#include "dataset/job/records.h"
#include "production/view_render.h"
#include "sampler/plan/plan.h"

namespace cps {

/// CPU nanoseconds that threads spent on the stages after the render.
struct ImageTimes {
  std::atomic<std::int64_t> warp_ns = 0, develop_ns = 0, encode_ns = 0, write_ns = 0;
};

/// Makes a view's images of its render and writes them, and the render where masters are kept; several at a
/// time, each on one thread. The sensor is drawn from the view and the group's number alone, so that it knows
/// nothing of the lens. Throws std::runtime_error in one line when a file cannot be written.
ViewRecord make_images(const Plan& plan, std::int64_t view, const RenderedHalves& halves,
                       const std::filesystem::path& root, ImageTimes& times);

}  // namespace cps
