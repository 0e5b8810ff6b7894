#include "tests/fuzz/mutate_bytes.h"

#include <algorithm>

std::vector<unsigned char> mutate_bytes(const std::vector<unsigned char>& original, cps::Stream stream) {
  using Bytes = std::vector<unsigned char>;
  Bytes bytes = original;
  std::uint64_t index = 0;
  const auto below = [&](std::uint64_t count) { return cps::random_below(stream, index++, count); };
  for (std::uint64_t left = 1 + below(2); left > 0 && !bytes.empty(); --left) {
    const std::size_t at = below(bytes.size()),
                      length = std::min<std::size_t>(1 + below(8), bytes.size() - at);
    switch (below(7)) {
      case 0:
        bytes[at] = static_cast<unsigned char>(below(256));
        break;
      case 1:
        bytes[at] ^= static_cast<unsigned char>(1u << below(8));
        break;
      case 2:
        bytes.erase(bytes.begin() + at, bytes.begin() + at + length);
        break;
      case 3: {
        const Bytes part(bytes.begin() + at, bytes.begin() + at + length);
        bytes.insert(bytes.begin() + at, part.begin(), part.end());
        break;
      }
      case 4:
        std::fill_n(bytes.begin() + at, length, below(2) ? 0xff : 0x00);
        break;
      case 5:  // changes a digit, since references and sizes are numbers in the JSON
        for (std::size_t i = at; i < bytes.size(); ++i)
          if (bytes[i] >= '0' && bytes[i] <= '9') {
            bytes[i] = static_cast<unsigned char>('0' + below(10));
            break;
          }
        break;
      default:
        if (below(10) == 0) bytes.resize(at);
    }
  }
  return bytes;
}
