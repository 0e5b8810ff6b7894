#pragma once

#include <filesystem>

#include "dataset/labels/reader.h"
#include "sampler/recipe/image_format.h"
#include "sensor/photograph.h"
#include "trainer/training/training_set.h"

namespace cps {

/// How a dataset stores its images.
struct StoredFormat {
  ImageFormat format = ImageFormat::png;
  int jpeg_quality = 95;
};

/// The gray image that would be read from the dataset's file, had the lens been in its plan: through the same
/// photograph(), format and gray conversion. Equal to it byte for byte, but for what the kept master's half
/// floats round off.
GrayImage online_image(const Master& master, const CroppedLens& lens, const Sensor& sensor,
                       const StoredFormat& stored);

/// The train part of a dataset that keeps its masters, with a new lens, crop and sensor noise for each master
/// in each epoch: drawn as the dataset's recipe draws them, and photographed and stored as its images are.
/// Orientation is measured in the picture that a lens makes, which is as large as the dataset's images; of
/// masters that were made for small images, it is that of small images. Augmentation then changes that
/// picture, before it is measured and reduced. Throws as load_master_cache() and draw_online_lens() do, and
/// when the recipe's lenses cannot be drawn for the label's H-FOV.
TrainingSet online_images(const Dataset& dataset, const TrainOptions& options,
                          const std::filesystem::path& cache_file);

}  // namespace cps
