#pragma once

#include <filesystem>

#include "dataset/labels/reader.h"
#include "trainer/training/training_set.h"

namespace cps {

/// The train part of a dataset that keeps its masters, with a new lens, crop and sensor noise for each master
/// in each epoch: drawn as the dataset's recipe says, and made by the same warp and sensor as its images.
/// Throws as load_master_cache() and draw_online_lens() do, and when the recipe's lenses cannot be drawn by
/// the label's H-FOV.
TrainingSet online_images(const Dataset& dataset, const TrainOptions& options,
                          const std::filesystem::path& cache_file);

}  // namespace cps
