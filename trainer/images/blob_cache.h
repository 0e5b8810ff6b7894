#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace cps {

/// Some of the things asked for cannot be used. what() is one line about the first and the number of others.
struct BadBlobs : std::runtime_error {
  std::vector<int> positions;        ///< in the list that was asked for, ascending
  std::vector<std::string> reasons;  ///< one line each, file first

  BadBlobs(std::vector<int> positions, std::vector<std::string> reasons);
};

/// Takes the things that cannot be used out of the list that was asked for, and adds why to `skipped`.
template <typename T>
void leave_out(const BadBlobs& bad, std::vector<T>& list, std::vector<std::string>& skipped) {
  for (std::size_t i = bad.positions.size(); i > 0; --i) list.erase(list.begin() + bad.positions[i - 1]);
  skipped.insert(skipped.end(), bad.reasons.begin(), bad.reasons.end());
}

/// Bytes that cost more to make than to keep: a list of blobs, in memory or mapped from a file.
struct BlobCache {
  std::vector<std::span<const std::uint8_t>> blobs;
  int made = 0;  ///< how many had to be made; the others were found ready
  std::shared_ptr<const std::uint8_t> memory;
};

/// Blobs of these sizes, from `file` when it was made for this `key` (all that their bytes depend on) and
/// every blob has its checksum; what is missing or damaged is made by fill(i, bytes), many at a time. The
/// file is made as FILE.partial, in which an interrupted run goes on where it stopped, and appears by atomic
/// rename. An empty `file` keeps everything in plain memory. The same bytes for any number of threads.
///
/// Throws BadBlobs for those whose fill() throws std::runtime_error (the others stay made),
/// HeldByAnother when another process is making this file, and std::runtime_error with one line when it
/// cannot be written.
BlobCache load_blob_cache(const std::string& key, const std::vector<std::size_t>& sizes,
                          const std::function<void(std::size_t i, std::span<std::uint8_t> bytes)>& fill,
                          const std::filesystem::path& file);

}  // namespace cps
