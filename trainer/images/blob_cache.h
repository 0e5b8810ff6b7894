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

/// Some of the requested blobs cannot be made. what() is one line about the first and the number of others.
struct BadBlobs : std::runtime_error {
  std::vector<int> positions;        ///< in the requested list, ascending
  std::vector<std::string> reasons;  ///< one line each, file first

  BadBlobs(std::vector<int> positions, std::vector<std::string> reasons);
};

/// Removes the entries that could not be made from the requested list, and appends the reasons to `skipped`.
template <typename T>
void leave_out(const BadBlobs& bad, std::vector<T>& list, std::vector<std::string>& skipped) {
  for (std::size_t i = bad.positions.size(); i > 0; --i) list.erase(list.begin() + bad.positions[i - 1]);
  skipped.insert(skipped.end(), bad.reasons.begin(), bad.reasons.end());
}

/// A list of byte blocks that are slow to compute, kept in memory or mapped from a file.
struct BlobCache {
  std::vector<std::span<const std::uint8_t>> blobs;
  int made = 0;                                ///< how many were computed; the others were found in the file
  std::shared_ptr<const std::uint8_t> memory;  ///< what `blobs` points into
};

/// Loads blobs of these sizes from `file` if it was written for the same `key` (a text of everything that
/// the bytes depend on). Missing blobs, and those whose checksum is wrong, are computed by fill(i, bytes) in
/// parallel. The file is written as FILE.partial, which an interrupted run continues, and is then renamed. An
/// empty `file` keeps everything in memory. The bytes do not depend on the number of threads.
///
/// Throws BadBlobs for those whose fill() throws std::runtime_error (the others stay in the file),
/// HeldByAnother if another process is writing this file, and std::runtime_error with one line if it cannot
/// be written.
BlobCache load_blob_cache(const std::string& key, const std::vector<std::size_t>& sizes,
                          const std::function<void(std::size_t i, std::span<std::uint8_t> bytes)>& fill,
                          const std::filesystem::path& file);

}  // namespace cps
