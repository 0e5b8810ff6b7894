#include "trainer/images/dataset_fingerprint.h"

#include <bit>
#include <cstdio>

#include "random/counter_hash.h"

namespace cps {

std::string dataset_fingerprint(const Dataset& dataset) {
  std::uint64_t hash = 0;
  const auto add = [&](std::uint64_t bits) { hash = mix64(hash ^ bits) + 0x9e3779b97f4a7c15ull; };
  for (const DatasetGroup& group : dataset.groups) {
    const Pinhole& c = group.label.camera;
    const Distortion& d = group.label.distortion;
    for (double v : {static_cast<double>(c.width), static_cast<double>(c.height), c.fx, c.fy, c.cx, c.cy,
                     d.k1, d.k2, d.k3, d.p1, d.p2})
      add(std::bit_cast<std::uint64_t>(v));
  }
  for (const DatasetImage& image : dataset.images) {
    for (char c : image.file.generic_string()) add(static_cast<unsigned char>(c));
    add(static_cast<std::uint64_t>(image.group));
    add(static_cast<std::uint64_t>(image.part));
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

}  // namespace cps
