#include "trainer/evaluation/truth_beside.h"

#include <fmt/format.h>

#include <stdexcept>

#include "dataset/labels/label.h"
#include "files/files.h"

namespace cps {

std::optional<CalibratedCamera> truth_beside(const std::filesystem::path& image, const ImageSize& size) {
  const std::filesystem::path file = image.parent_path() / "calibration.json";
  if (!std::filesystem::exists(file)) return std::nullopt;
  const Label label = label_from_json(read_json(file), file.string());
  if (ImageSize{label.camera.width, label.camera.height} != size)
    throw std::runtime_error(
        fmt::format("{}: is {}x{}, not the size in its calibration.json: move one of them to another folder",
                    image.string(), size.width, size.height));
  return CalibratedCamera{label.rig_camera, label.camera, label.distortion};
}

}  // namespace cps
