#include "trainer/images/batches.h"

#include <algorithm>
#include <map>
#include <utility>

#include "random/shuffle.h"

namespace cps {
namespace {

using ImagesBySize = std::map<ImageSize, std::vector<int>>;

ImagesBySize group_by_size(std::span<const ImageSize> sizes) {
  ImagesBySize groups;
  for (int i = 0; i < static_cast<int>(sizes.size()); ++i) groups[sizes[i]].push_back(i);
  return groups;
}

std::vector<Batch> interleaved(const ImagesBySize& groups, int batch_size) {
  std::vector<std::pair<double, Batch>> placed;  // by where in the epoch the batch falls
  for (const auto& [size, images] : groups) {
    const std::size_t n = images.size(), count = (n + batch_size - 1) / batch_size;
    for (std::size_t b = 0; b < count; ++b)
      placed.emplace_back((b + .5) / count,
                          Batch(images.begin() + b * n / count, images.begin() + (b + 1) * n / count));
  }
  std::ranges::stable_sort(placed, {}, &std::pair<double, Batch>::first);
  std::vector<Batch> batches;
  for (auto& [position, batch] : placed) batches.push_back(std::move(batch));
  return batches;
}

}  // namespace

std::vector<Batch> shuffled_batches(std::span<const ImageSize> sizes, int batch_size, std::uint64_t seed,
                                    int epoch) {
  ImagesBySize groups = group_by_size(sizes);
  const Stream stream = substream(make_stream(seed, "batches"), epoch);
  std::uint64_t group = 0;
  for (auto& [size, images] : groups) shuffle(images, substream(stream, group++), 1);
  return interleaved(groups, batch_size);
}

std::vector<Batch> ordered_batches(std::span<const ImageSize> sizes, int batch_size) {
  return interleaved(group_by_size(sizes), batch_size);
}

bool is_mirrored(std::uint64_t seed, int epoch, int image) {
  return random_bits(substream(make_stream(seed, "mirror"), epoch), image) & 1;
}

}  // namespace cps
