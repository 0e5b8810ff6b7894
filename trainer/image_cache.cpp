#include "trainer/image_cache.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <cstring>
#include <stdexcept>

#include "dataset/files.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

struct Failures {
  std::vector<int> positions;
  std::vector<std::string> reasons;

  void add(std::size_t position, const std::string& reason) {
    positions.push_back(static_cast<int>(position));
    reasons.push_back(reason);
  }
  void check() {
    if (!positions.empty()) throw BadImages(std::move(positions), std::move(reasons));
  }
};

/// What the pixels depend on, as text. It opens the file, padded to `alignment`; the pixels follow.
std::string cache_key(const Dataset& dataset, std::span<const int> images, const Reduction& reduction) {
  std::string key = "cps gray images 1\nwidth " + std::to_string(reduction.width) + " factor " +
                    std::to_string(reduction.factor) + "\n";
  Failures missing;
  for (std::size_t n = 0; n < images.size(); ++n) {
    const fs::path& name = dataset.images[images[n]].file;
    const fs::path file = dataset.root / name;
    std::error_code no_size, no_time;
    const auto bytes = fs::file_size(file, no_size);
    const auto time = fs::last_write_time(file, no_time);
    if (no_size || no_time)
      missing.add(
          n, file.string() + ": missing though the dataset lists it: restore it or make the dataset again");
    else
      key += name.string() + " " + std::to_string(bytes) + " " +
             std::to_string(time.time_since_epoch().count()) + "\n";
  }
  missing.check();
  constexpr std::size_t alignment = 4096;
  key.resize((key.size() + alignment) / alignment * alignment, '\0');
  return key;
}

/// The whole file as memory, if it starts with `key` and has the right length.
std::shared_ptr<const std::uint8_t> map_file(const fs::path& file, const std::string& key,
                                             std::size_t length) {
  const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return nullptr;
  struct stat status {};
  void* memory = MAP_FAILED;
  if (fstat(descriptor, &status) == 0 && static_cast<std::size_t>(status.st_size) == length)
    memory = mmap(nullptr, length, PROT_READ, MAP_PRIVATE, descriptor, 0);
  close(descriptor);
  if (memory == MAP_FAILED) return nullptr;
  std::shared_ptr<const std::uint8_t> mapped(
      static_cast<const std::uint8_t*>(memory),
      [length](const std::uint8_t* p) { munmap(const_cast<std::uint8_t*>(p), length); });
  return std::memcmp(mapped.get(), key.data(), key.size()) == 0 ? mapped : nullptr;
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

BadImages::BadImages(std::vector<int> at, std::vector<std::string> why)
    : std::runtime_error(why.front() +
                         (why.size() > 1 ? " (and " + std::to_string(why.size() - 1) + " more)" : "")),
      positions(std::move(at)),
      reasons(std::move(why)) {}

ImageCache load_image_cache(const Dataset& dataset, std::span<const int> images, const Reduction& reduction,
                            const fs::path& file) {
  const std::string key = cache_key(dataset, images, reduction);
  ImageCache cache;
  std::vector<std::size_t> offsets;
  std::size_t end = key.size();
  for (int i : images) {
    const Pinhole& camera = dataset.groups[dataset.images[i].group].label.camera;
    cache.originals.push_back({camera.width, camera.height});
    cache.images.push_back({reduced_size(cache.originals.back(), reduction), nullptr});
    offsets.push_back(end);
    end += static_cast<std::size_t>(cache.images.back().size.width) * cache.images.back().size.height;
  }

  if (!file.empty()) cache.memory = map_file(file, key, end);
  if (!cache.memory) {
    cache.was_decoded = true;
    auto bytes = std::make_shared<std::vector<std::uint8_t>>(end);
    std::memcpy(bytes->data(), key.data(), key.size());
    std::vector<std::string> reasons(images.size());
    tbb::parallel_for(std::size_t{0}, images.size(), [&](std::size_t i) {
      try {
        const GrayImage gray = decode(dataset, images[i], reduction);
        std::memcpy(bytes->data() + offsets[i], gray.pixels.data(), gray.pixels.size());
      } catch (const std::runtime_error& error) {
        reasons[i] = error.what();
      }
    });
    Failures failures;
    for (std::size_t i = 0; i < reasons.size(); ++i)
      if (!reasons[i].empty()) failures.add(i, reasons[i]);
    failures.check();
    cache.memory = std::shared_ptr<const std::uint8_t>(bytes, bytes->data());
    if (!file.empty()) {
      write_file(file, {reinterpret_cast<const char*>(bytes->data()), bytes->size()});
      if (auto mapped = map_file(file, key, end)) cache.memory = mapped;
    }
  }
  for (std::size_t i = 0; i < images.size(); ++i) cache.images[i].pixels = cache.memory.get() + offsets[i];
  return cache;
}

}  // namespace cps
