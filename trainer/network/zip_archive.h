#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cps {

/// The bytes of a ZIP archive (PKWARE APPNOTE 6.3) whose entries are stored, not compressed: the container
/// that PyTorch keeps weights in. Entries' data begin at multiples of 64 bytes, as PyTorch's do.
std::string zip_stored(const std::vector<std::pair<std::string, std::string_view>>& entries);

/// The entries of such an archive by name; views into `bytes`. Throws std::runtime_error when it is none, is
/// cut short, or compresses.
std::map<std::string, std::string_view> unzip_stored(std::string_view bytes);

}  // namespace cps
