#pragma once

#include <cstdint>
#include <filesystem>

#include "dataset/labels/reader.h"
#include "distortion/models/model_camera.h"

namespace cps {

/// A unified spherical camera of `size` × `size` pixels with DeepCalib's two numbers, uniform in their
/// intervals, and a lens that is proved on its frame.
ModelCamera draw_sphere(int size, std::uint64_t lens);

struct SphereDatasetOptions {
  int size = 48;  ///< of the square images
  int train_lenses = 8, val_lenses = 2, test_lenses = 3;
};

/// Writes a dataset of streets (tests/trainer/street.h) seen by such cameras, each a leaf folder with one
/// image, and reads it back. No place and no lens occurs in two parts.
Dataset make_sphere_dataset(const std::filesystem::path& root, const SphereDatasetOptions& options = {});

}  // namespace cps
