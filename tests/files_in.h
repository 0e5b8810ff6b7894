#pragma once

#include <cstddef>
#include <filesystem>

namespace cps {

/// Number of files and links in a folder and in those below it.
inline std::size_t files_in(const std::filesystem::path& folder) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    count += !entry.is_directory();
  return count;
}

}  // namespace cps
