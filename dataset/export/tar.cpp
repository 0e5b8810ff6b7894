#include "dataset/export/tar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

namespace cps {
namespace {

constexpr std::size_t block_bytes = 512;
using Block = std::array<char, block_bytes>;

void put(Block& block, std::size_t offset, const std::string& text) {
  std::copy(text.begin(), text.end(), block.begin() + static_cast<std::ptrdiff_t>(offset));
}

Block header(const std::string& name, std::uint64_t bytes) {
  constexpr std::size_t longest_name = 100;
  constexpr std::uint64_t size_limit = std::uint64_t{1} << 33;  // eleven octal digits
  if (name.empty() || name.size() > longest_name)
    throw std::runtime_error(name + ": a tar's file name must have 1 to 100 bytes");
  if (bytes >= size_limit) throw std::runtime_error(name + ": a tar's file must be smaller than 8 GiB");
  Block block{};
  put(block, 0, name);
  put(block, 100, "0000644");                      // mode
  put(block, 108, "0000000");                      // uid
  put(block, 116, "0000000");                      // gid
  put(block, 124, fmt::format("{:011o}", bytes));  // size
  put(block, 136, "00000000000");                  // mtime
  put(block, 148, "        ");                     // checksum, for its own sum
  put(block, 156, "0");                            // a plain file
  put(block, 257,
      std::string("ustar\0"
                  "00",
                  8));         // magic and version
  put(block, 329, "0000000");  // device numbers
  put(block, 337, "0000000");
  const int sum = std::accumulate(block.begin(), block.end(), 0,
                                  [](int s, char c) { return s + static_cast<unsigned char>(c); });
  put(block, 148, fmt::format("{:06o}", sum) + std::string("\0 ", 2));
  return block;
}

}  // namespace

void add_to_tar(const Append& append, const std::string& name, std::span<const char> bytes) {
  append(header(name, bytes.size()));
  append(bytes);
  static constexpr Block zeros{};
  append(std::span(zeros).first((block_bytes - bytes.size() % block_bytes) % block_bytes));
}

void end_tar(const Append& append) {
  static constexpr std::array<char, tar_end_bytes> zeros{};
  append(zeros);
}

std::uint64_t size_in_tar(std::uint64_t bytes) {
  return block_bytes + (bytes + block_bytes - 1) / block_bytes * block_bytes;
}

}  // namespace cps
