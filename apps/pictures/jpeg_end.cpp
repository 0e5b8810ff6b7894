#include "apps/pictures/jpeg_end.h"

#include <cstddef>

namespace cps {

// ITU-T T.81, annex B: a marker is 0xFF and a byte that is neither 0 nor 0xFF. All segments but RSTn, SOI,
// EOI and TEM carry their length. Entropy-coded data follows SOS; in it, 0xFF is followed by 0 or by RSTn.
bool has_whole_image(std::string_view jpeg) {
  constexpr int tem = 0x01, rst0 = 0xd0, rst7 = 0xd7, soi = 0xd8, eoi = 0xd9, sos = 0xda;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(jpeg[i]); };
  bool has_scan = false;
  for (std::size_t i = 0; i + 1 < jpeg.size();) {
    const int marker = byte(i + 1);
    if (byte(i) != 0xff || marker == 0 || (marker >= rst0 && marker <= rst7)) {
      ++i;  // entropy-coded data
    } else if (marker == 0xff) {
      ++i;  // padding before a marker
    } else if (marker == eoi) {
      return has_scan;
    } else if (marker == soi || marker == tem) {
      i += 2;
    } else {
      if (i + 3 >= jpeg.size()) return false;
      has_scan = has_scan || marker == sos;
      i += 2 + (byte(i + 2) << 8 | byte(i + 3));
    }
  }
  return false;
}

}  // namespace cps
