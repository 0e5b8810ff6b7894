#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "trainer/images/gray_image.h"

namespace cps {

/// One image on its way into a batch.
struct BatchImage {
  GrayView gray;
  ImageSize original;
  bool mirror = false;
};

/// Indices of the images of one batch; all have the same size.
using Batch = std::vector<int>;

/// Every image exactly once, in batches of one size and at most `batch_size` images. Within a size, batches
/// differ by at most one image (batch normalisation wants no stragglers); the sizes take turns in proportion
/// to their numbers. The order is a pure function of (sizes, batch_size, seed, epoch).
std::vector<Batch> shuffled_batches(std::span<const ImageSize> sizes, int batch_size, std::uint64_t seed,
                                    int epoch);

/// The same without shuffling, for evaluation.
std::vector<Batch> ordered_batches(std::span<const ImageSize> sizes, int batch_size);

/// Whether `image` is seen mirrored in this epoch: a fair coin, the same on every machine.
bool is_mirrored(std::uint64_t seed, int epoch, int image);

}  // namespace cps
