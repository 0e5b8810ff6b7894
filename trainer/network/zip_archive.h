#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// The container of PyTorch's weight files: a ZIP archive (PKWARE APPNOTE 6.3) whose entries are stored, not
/// compressed. LibTorch's own caffe2/serialize/inline_container.h is not used: its writer adds entries of its
/// own (version, byte order, a serialization id that hashes the entries), which differ between LibTorch
/// releases, so equal weights would not give equal files.
namespace cps {

/// The bytes of such an archive. The data of each entry starts at a multiple of 64 bytes, as PyTorch aligns
/// it. Throws std::runtime_error if it would exceed 4 GB.
std::string zip_stored(const std::vector<std::pair<std::string, std::string_view>>& entries);

/// The entries of such an archive by name; views into `bytes`. Throws std::runtime_error if `bytes` is not an
/// archive, is cut short, holds a compressed entry or two of one name, or if an entry fails its checksum.
std::map<std::string, std::string_view> unzip_stored(std::string_view bytes);

}  // namespace cps
