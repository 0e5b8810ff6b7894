#pragma once

#include <OpenImageIO/imagebuf.h>

#include <cstring>

namespace cps {

/// Whether two pictures in memory have as many bytes, and the same ones.
inline bool same_bytes(const OIIO::ImageBuf& a, const OIIO::ImageBuf& b) {
  return a.spec().image_bytes() == b.spec().image_bytes() &&
         std::memcmp(a.localpixels(), b.localpixels(), a.spec().image_bytes()) == 0;
}

}  // namespace cps
