#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "trainer/images/gray_image.h"
#include "trainer/images/orientation/orientation.h"

namespace cps {

/// One image of a batch, before it becomes part of a tensor.
struct BatchImage {
  GrayView gray;
  ImageSize original;             ///< before reduction
  bool mirror = false;            ///< flip left to right
  OrientationView orientation{};  ///< not flipped; without planes for a network that has no orientation
};

/// Indices of the images of one batch, which all have the same size.
using Batch = std::vector<int>;

/// Splits the images into batches: each image once, one image size per batch, at most `batch_size` images.
/// Batches of one size differ by at most one image, because batch normalisation needs no small last batch;
/// different sizes alternate in proportion to their counts. A pure function of its arguments.
std::vector<Batch> shuffled_batches(std::span<const ImageSize> sizes, int batch_size, std::uint64_t seed,
                                    int epoch);

/// The same in the given order, for evaluation.
std::vector<Batch> ordered_batches(std::span<const ImageSize> sizes, int batch_size);

/// Whether `image` is mirrored in this epoch: true with probability 1/2, the same on every machine.
bool is_mirrored(std::uint64_t seed, int epoch, int image);

}  // namespace cps
