#include <algorithm>
#include <cstring>

#include "tests/fuzz/mutate_bytes.h"

/// Stands in for libFuzzer's mutation of bytes in programs without it: the n-th call of a process always does
/// the same.
extern "C" std::size_t LLVMFuzzerMutate(unsigned char* data, std::size_t size, std::size_t max_size) {
  static std::uint64_t calls = 0;
  const cps::Stream stream = cps::substream(cps::make_stream(0, "plain mutations"), calls++);
  std::vector<unsigned char> bytes = mutate_bytes({data, data + size}, stream);
  bytes.resize(std::min(bytes.size(), max_size));
  std::copy(bytes.begin(), bytes.end(), data);
  return bytes.size();
}
