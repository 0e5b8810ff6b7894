#include "trainer/images/dataset_fingerprint.h"

#include <fmt/format.h>

#include "files/files.h"

namespace cps {

std::string dataset_fingerprint(const Dataset& dataset) {
  std::string text;
  for (const DatasetGroup& group : dataset.groups) {
    const Pinhole& c = group.label.camera;
    const Distortion& d = group.label.distortion;
    text += fmt::format("{} {} {} {} {} {} {} {} {} {} {}\n", c.width, c.height, c.fx, c.fy, c.cx, c.cy, d.k1,
                        d.k2, d.k3, d.p1, d.p2);
    if (!group.model) continue;
    const LensModel& lens = group.model->camera.lens;
    text += family_name(lens);
    for (const auto& [name, value] : parameters(lens)) text += fmt::format(" {} {}", name, value);
    text += "\n";
  }
  for (const DatasetImage& image : dataset.images)
    text += fmt::format("{} {} {}\n", image.group, to_string(image.part), image.file.generic_string());
  return sha256(text);
}

}  // namespace cps
