#include <algorithm>
#include <array>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "dataset/exchange/formats/formats.h"
#include "dataset/exchange/plausible_camera.h"
#include "files/files.h"

namespace cps {
namespace {

struct Writer {
  CalibrationFormat format;
  std::string (*write)(CameraSpan);
  std::array<std::string_view, 6> families;  ///< that the format can say
};
constexpr std::array<std::string_view, 6> all_families{"brown_conrady",     "rational", "kannala_brandt",
                                                       "unified_spherical", "eucm",     "double_sphere"};
constexpr std::array<std::string_view, 6> opencv_families{"brown_conrady", "rational", "kannala_brandt",
                                                          "unified_spherical"};
constexpr std::array<Writer, 8> writers{
    {{CalibrationFormat::cps, write_cps, all_families},
     {CalibrationFormat::opencv_yaml, write_opencv_yaml, opencv_families},
     {CalibrationFormat::opencv_xml, write_opencv_xml, opencv_families},
     {CalibrationFormat::colmap, write_colmap, {"brown_conrady", "rational", "kannala_brandt", "eucm"}},
     {CalibrationFormat::ros, write_ros, {"brown_conrady", "rational", "kannala_brandt"}},
     {CalibrationFormat::kitti, write_kitti, {"brown_conrady"}},
     {CalibrationFormat::kalibr,
      write_kalibr,
      {"brown_conrady", "kannala_brandt", "unified_spherical", "eucm", "double_sphere"}},
     {CalibrationFormat::nerfstudio, write_nerfstudio, {"brown_conrady", "kannala_brandt"}}}};

const Writer& writer_of(CalibrationFormat format) {
  return *std::ranges::find(writers, format, &Writer::format);
}

bool says_family(CalibrationFormat format, const LensModel& lens) {
  const auto& families = writer_of(format).families;
  return std::ranges::find(families, family_name(lens)) != families.end();
}

/// k3, where the format has no place for it; otherwise 0.
double left_out_k3(CalibrationFormat format, const LensModel& lens) {
  if (format == CalibrationFormat::cps) return 0;
  if (const auto* sphere = std::get_if<UnifiedSpherical>(&lens)) return sphere->distortion.k3;
  const auto* brown_conrady = std::get_if<Distortion>(&lens);
  return brown_conrady != nullptr && format == CalibrationFormat::kalibr ? brown_conrady->k3 : 0;
}

/// Throws, naming the formats that can hold the lens, if this one cannot.
void require_held(CalibrationFormat format, const ModelCamera& camera) {
  if (can_hold(format, camera.lens)) return;
  std::string others;
  for (const Writer& writer : writers)
    if (can_hold(writer.format, camera.lens))
      others += (others.empty() ? "" : ", ") + to_string(writer.format);
  const std::string why = says_family(format, camera.lens)
                              ? "k3 is not 0, which " + to_string(format) + " has no place for"
                              : "its lens model is " + std::string(family_name(camera.lens)) + ", which " +
                                    to_string(format) + " cannot say";
  throw std::runtime_error(camera.name + ": " + why + ": write it as " + others);
}

}  // namespace

bool can_hold(CalibrationFormat format, const LensModel& lens) {
  return says_family(format, lens) && left_out_k3(format, lens) == 0;
}

void write_model_calibration(const std::filesystem::path& file, CalibrationFormat format,
                             std::span<const ModelCamera> cameras) try {
  for (const ModelCamera& camera : cameras) {
    check_plausible(camera, camera.name);
    require_held(format, camera);
  }
  write_file(file, writer_of(format).write(cameras));
} catch (const std::runtime_error& error) {
  const std::string what = error.what();
  throw std::runtime_error(what.starts_with(file.string()) ? what : file.string() + ": " + what);
}

}  // namespace cps
