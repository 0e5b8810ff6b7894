#include "trainer/images/blob_cache.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <tbb/parallel_for.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <numeric>

#include "files/file_lock.h"
#include "random/counter_hash.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// The file: the key, padded; a checksum per blob, 0 if it is not computed yet; the blobs.
struct Layout {
  std::string key;
  std::vector<std::size_t> sizes, offsets;
  std::size_t length = 0;

  Layout(std::string text, const std::vector<std::size_t>& blob_sizes)
      : key(std::move(text)), sizes(blob_sizes) {
    constexpr std::size_t alignment = 4096;
    key.resize((key.size() + alignment) / alignment * alignment, '\0');
    length = key.size() + sizes.size() * sizeof(std::uint64_t);
    for (std::size_t size : sizes) {
      offsets.push_back(length);
      length += size;
    }
  }
  std::size_t checksum_offset(std::size_t i) const { return key.size() + i * sizeof(std::uint64_t); }
};

std::uint64_t checksum(std::span<const std::uint8_t> bytes) {
  std::uint64_t hash = bytes.size();
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    std::uint64_t word;
    std::memcpy(&word, &bytes[i], 8);
    hash = mix64(hash ^ word);
  }
  for (; i < bytes.size(); ++i) hash = mix64(hash ^ bytes[i]);
  return hash == 0 ? 1 : hash;
}

bool is_made(const std::uint8_t* memory, const Layout& layout, std::size_t i) {
  std::uint64_t stored;
  std::memcpy(&stored, memory + layout.checksum_offset(i), sizeof stored);
  return stored != 0 && stored == checksum({memory + layout.offsets[i], layout.sizes[i]});
}

/// Computes the missing blobs. Returns how many there were.
int make_missing(std::uint8_t* memory, const Layout& layout,
                 const std::function<void(std::size_t, std::span<std::uint8_t>)>& fill) {
  std::vector<std::string> reasons(layout.sizes.size());
  std::atomic<int> made = 0;
  tbb::parallel_for(std::size_t{0}, layout.sizes.size(), [&](std::size_t i) {
    if (is_made(memory, layout, i)) return;
    const std::span<std::uint8_t> bytes(memory + layout.offsets[i], layout.sizes[i]);
    try {
      fill(i, bytes);
    } catch (const std::runtime_error& error) {
      reasons[i] = error.what();
      return;
    }
    const std::uint64_t sum = checksum(bytes);
    std::memcpy(memory + layout.checksum_offset(i), &sum, sizeof sum);
    ++made;
  });
  std::vector<int> positions;
  std::vector<std::string> why;
  for (std::size_t i = 0; i < reasons.size(); ++i)
    if (!reasons[i].empty()) {
      positions.push_back(static_cast<int>(i));
      why.push_back(reasons[i]);
    }
  if (!positions.empty()) throw BadBlobs(std::move(positions), std::move(why));
  return made;
}

[[noreturn]] void cannot_be_written(const fs::path& file, int error) {
  throw std::runtime_error(file.string() + ": cannot be written: " + std::strerror(error));
}

/// Maps the whole file, if it has the layout's key and length; otherwise null.
std::shared_ptr<std::uint8_t> map_file(const fs::path& file, const Layout& layout, bool to_write) {
  const int descriptor = open(file.c_str(), (to_write ? O_RDWR : O_RDONLY) | O_CLOEXEC);
  if (descriptor < 0) return nullptr;
  struct stat status {};
  void* memory = MAP_FAILED;
  if (fstat(descriptor, &status) == 0 && static_cast<std::size_t>(status.st_size) == layout.length)
    memory = mmap(nullptr, layout.length, to_write ? PROT_READ | PROT_WRITE : PROT_READ,
                  to_write ? MAP_SHARED : MAP_PRIVATE, descriptor, 0);
  close(descriptor);
  if (memory == MAP_FAILED) return nullptr;
  std::shared_ptr<std::uint8_t> mapped(static_cast<std::uint8_t*>(memory),
                                       [length = layout.length](std::uint8_t* p) { munmap(p, length); });
  return std::memcmp(mapped.get(), layout.key.data(), layout.key.size()) == 0 ? mapped : nullptr;
}

/// Creates the file with no blob computed.
void start_file(const fs::path& file, const Layout& layout) {
  const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) cannot_be_written(file, errno);
  // Reserve the space now: writing to a mapped page on a full disk would kill the process.
  int error = posix_fallocate(descriptor, 0, static_cast<off_t>(layout.length));
  if (error == 0 &&
      pwrite(descriptor, layout.key.data(), layout.key.size(), 0) != static_cast<ssize_t>(layout.key.size()))
    error = errno;
  close(descriptor);
  if (error != 0) {
    fs::remove(file);
    cannot_be_written(file, error);
  }
}

/// Completes the file. Returns how many blobs had to be computed.
int make_file(const fs::path& file, const Layout& layout,
              const std::function<void(std::size_t, std::span<std::uint8_t>)>& fill) {
  const fs::path partial = file.string() + ".partial";
  const FileLock lock(file.string() + ".lock", FileLock::Kind::exclusive);
  if (!lock.is_held())
    throw HeldByAnother(file.string() + ": is being written by another process: wait for it");
  if (fs::exists(file)) fs::rename(file, partial);  // damaged, or of another key
  auto memory = map_file(partial, layout, true);
  if (!memory) {
    start_file(partial, layout);
    memory = map_file(partial, layout, true);
    if (!memory) cannot_be_written(partial, errno);
  }
  const int made = make_missing(memory.get(), layout, fill);
  if (msync(memory.get(), layout.length, MS_SYNC) != 0) cannot_be_written(partial, errno);
  fs::rename(partial, file);
  return made;
}

bool is_whole(const std::uint8_t* memory, const Layout& layout) {
  std::atomic<bool> whole = true;
  tbb::parallel_for(std::size_t{0}, layout.sizes.size(), [&](std::size_t i) {
    if (!is_made(memory, layout, i)) whole = false;
  });
  return whole;
}

}  // namespace

BadBlobs::BadBlobs(std::vector<int> at, std::vector<std::string> why)
    : std::runtime_error(why.front() +
                         (why.size() > 1 ? " (and " + std::to_string(why.size() - 1) + " more)" : "")),
      positions(std::move(at)),
      reasons(std::move(why)) {}

BlobCache load_blob_cache(const std::string& key, const std::vector<std::size_t>& sizes,
                          const std::function<void(std::size_t i, std::span<std::uint8_t> bytes)>& fill,
                          const fs::path& file) {
  const Layout layout(key, sizes);
  BlobCache cache;
  if (file.empty()) {
    const auto bytes = std::make_shared<std::vector<std::uint8_t>>(layout.length);
    cache.made = make_missing(bytes->data(), layout, fill);
    cache.memory = std::shared_ptr<const std::uint8_t>(bytes, bytes->data());
  } else {
    cache.memory = map_file(file, layout, false);
    if (!cache.memory || !is_whole(cache.memory.get(), layout)) {
      cache.memory.reset();
      cache.made = make_file(file, layout, fill);
      cache.memory = map_file(file, layout, false);
      if (!cache.memory) throw std::runtime_error(file.string() + ": cannot be read again");
    }
  }
  for (std::size_t i = 0; i < sizes.size(); ++i)
    cache.blobs.emplace_back(cache.memory.get() + layout.offsets[i], sizes[i]);
  return cache;
}

}  // namespace cps
