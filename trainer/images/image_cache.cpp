#include "trainer/images/image_cache.h"

#include <algorithm>
#include <stdexcept>

#include "trainer/images/blob_cache.h"
#include "trainer/images/dataset_fingerprint.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// Everything that the pixels depend on. A missing file has no size here; decoding it reports the error.
std::string cache_key(const Dataset& dataset, std::span<const int> images, const Reduction& reduction) {
  std::string key = "cps gray images 3\ndataset " + dataset_fingerprint(dataset) + "\nwidth " +
                    std::to_string(reduction.width) + " factor " + std::to_string(reduction.factor) + "\n";
  for (int i : images) {
    const fs::path file = dataset.root / dataset.images[i].file;
    std::error_code no_size, no_time;
    const auto bytes = fs::file_size(file, no_size);
    const auto time = fs::last_write_time(file, no_time);
    key += dataset.images[i].file.string() + " " + (no_size ? "-" : std::to_string(bytes)) + " " +
           (no_time ? "-" : std::to_string(time.time_since_epoch().count())) + "\n";
  }
  return key;
}

GrayImage decode(const Dataset& dataset, int image, const Reduction& reduction) {
  const DatasetImage& entry = dataset.images[image];
  const Pinhole& camera = dataset.groups[entry.group].label.camera;
  const fs::path file = dataset.root / entry.file;
  const GrayImage gray = read_gray_image(file);
  if (gray.size != ImageSize{camera.width, camera.height})
    throw std::runtime_error(file.string() + ": is " + std::to_string(gray.size.width) + "x" +
                             std::to_string(gray.size.height) + " but its calibration.json says " +
                             std::to_string(camera.width) + "x" + std::to_string(camera.height) +
                             ": a resized image needs a new label");
  return area_average(gray, reduced_size(gray.size, reduction));
}

}  // namespace

ImageCache load_image_cache(const Dataset& dataset, std::span<const int> images, const Reduction& reduction,
                            const fs::path& file) {
  ImageCache cache;
  std::vector<std::size_t> sizes;
  for (int i : images) {
    const Pinhole& camera = dataset.groups[dataset.images[i].group].label.camera;
    cache.originals.push_back({camera.width, camera.height});
    cache.images.push_back({reduced_size(cache.originals.back(), reduction), nullptr});
    sizes.push_back(pixel_count(cache.images.back().size));
  }
  const BlobCache blobs = load_blob_cache(
      cache_key(dataset, images, reduction), sizes,
      [&](std::size_t i, std::span<std::uint8_t> pixels) {
        std::ranges::copy(decode(dataset, images[i], reduction).pixels, pixels.begin());
      },
      file);
  cache.decoded = blobs.made;
  cache.memory = blobs.memory;
  for (std::size_t i = 0; i < images.size(); ++i) cache.images[i].pixels = blobs.blobs[i].data();
  return cache;
}

}  // namespace cps
