#include "trainer/images/image_cache.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "trainer/images/blob_cache.h"
#include "trainer/images/dataset_fingerprint.h"
#include "trainer/images/network_image.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// Everything that the pixels depend on. A missing file has no size here; decoding it reports the error.
std::string cache_key(const Dataset& dataset, std::span<const int> images, const Reduction& reduction,
                      const OrientationOptions& orientation) {
  std::string key = "cps gray images 3\ndataset " + dataset_fingerprint(dataset) + "\nwidth " +
                    std::to_string(reduction.width) + " factor " + std::to_string(reduction.factor) + "\n";
  if (orientation.measured) key += "orientation 2 in width " + std::to_string(orientation.max_width) + "\n";
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

GrayImage decode(const Dataset& dataset, int image) {
  const DatasetImage& entry = dataset.images[image];
  const Pinhole& camera = dataset.groups[entry.group].label.camera;
  const fs::path file = dataset.root / entry.file;
  GrayImage gray = read_gray_image(file);
  if (gray.size != ImageSize{camera.width, camera.height})
    throw std::runtime_error(file.string() + ": is " + std::to_string(gray.size.width) + "x" +
                             std::to_string(gray.size.height) + " but its calibration.json says " +
                             std::to_string(camera.width) + "x" + std::to_string(camera.height) +
                             ": a resized image needs a new label");
  return gray;
}

/// An image's bytes in the cache: the pixels, then, if measured, the orientation's planes and its numbers.
std::size_t byte_count(const ImageSize& reduced, const OrientationOptions& orientation) {
  if (!orientation.measured) return pixel_count(reduced);
  return pixel_count(reduced) + plane_bytes(orientation_grid(reduced)) + sizeof(OrientationNumbers);
}

void store(const NetworkImage& image, std::span<std::uint8_t> bytes) {
  std::uint8_t* out = std::ranges::copy(image.gray.pixels, bytes.data()).out;
  if (image.orientation.planes.empty()) return;
  std::memcpy(out, image.orientation.planes.data(), image.orientation.planes.size());
  std::memcpy(out + image.orientation.planes.size(), &image.orientation.numbers, sizeof(OrientationNumbers));
}

OrientationView stored_orientation(std::span<const std::uint8_t> bytes, const ImageSize& reduced,
                                   const OrientationOptions& orientation) {
  OrientationView view;
  if (!orientation.measured) return view;
  view.grid = orientation_grid(reduced);
  const std::uint8_t* planes = bytes.data() + pixel_count(reduced);
  view.planes = reinterpret_cast<const std::int8_t*>(planes);
  std::memcpy(&view.numbers, planes + plane_bytes(view.grid), sizeof(OrientationNumbers));
  return view;
}

}  // namespace

ImageCache load_image_cache(const Dataset& dataset, std::span<const int> images, const Reduction& reduction,
                            const fs::path& file, const OrientationOptions& orientation) {
  ImageCache cache;
  std::vector<std::size_t> sizes;
  for (int i : images) {
    const Pinhole& camera = dataset.groups[dataset.images[i].group].label.camera;
    cache.originals.push_back({camera.width, camera.height});
    cache.images.push_back({reduced_size(cache.originals.back(), reduction), nullptr});
    sizes.push_back(byte_count(cache.images.back().size, orientation));
  }
  const BlobCache blobs = load_blob_cache(
      cache_key(dataset, images, reduction, orientation), sizes,
      [&](std::size_t i, std::span<std::uint8_t> bytes) {
        store(network_image(decode(dataset, images[i]), reduction, orientation), bytes);
      },
      file);
  cache.decoded = blobs.made;
  cache.memory = blobs.memory;
  for (std::size_t i = 0; i < images.size(); ++i) {
    cache.images[i].pixels = blobs.blobs[i].data();
    cache.orientations.push_back(stored_orientation(blobs.blobs[i], cache.images[i].size, orientation));
  }
  return cache;
}

}  // namespace cps
