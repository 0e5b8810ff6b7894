#include "dataset/exchange/calibration_file.h"

#include <array>
#include <stdexcept>
#include <utility>

#include "dataset/exchange/markup.h"
#include "dataset/exchange/model_calibration.h"

namespace cps {
namespace {

constexpr std::array<std::pair<CalibrationFormat, const char*>, 8> names{
    {{CalibrationFormat::cps, "cps"},
     {CalibrationFormat::opencv_yaml, "opencv-yaml"},
     {CalibrationFormat::opencv_xml, "opencv-xml"},
     {CalibrationFormat::colmap, "colmap"},
     {CalibrationFormat::ros, "ros"},
     {CalibrationFormat::kitti, "kitti"},
     {CalibrationFormat::kalibr, "kalibr"},
     {CalibrationFormat::nerfstudio, "nerfstudio"}}};

constexpr std::array<CalibrationFormat, names.size()> all_formats = [] {
  std::array<CalibrationFormat, names.size()> formats{};
  for (std::size_t i = 0; i < names.size(); ++i) formats[i] = names[i].first;
  return formats;
}();

CalibratedCamera brown_conrady(const ModelCamera& camera, const std::filesystem::path& file) {
  if (const auto* lens = std::get_if<Distortion>(&camera.lens)) return {camera.name, camera.pinhole, *lens};
  throw std::runtime_error(one_line(
      file.string() + ": " + camera.name + ": its lens model is " + std::string(family_name(camera.lens)) +
      ", but only brown_conrady can be used here: fit one with cps lens convert"));
}

}  // namespace

std::string to_string(CalibrationFormat format) {
  for (const auto& [known, name] : names)
    if (known == format) return name;
  return {};
}

CalibrationFormat calibration_format_from_string(const std::string& name) {
  std::string known;
  for (const auto& [format, known_name] : names) {
    if (known_name == name) return format;
    known += std::string(known.empty() ? "" : ", ") + known_name;
  }
  throw std::runtime_error("format: '" + name + "' is none of " + known);
}

std::span<const CalibrationFormat> calibration_formats() {
  return all_formats;
}

std::string usual_file_name(CalibrationFormat format) {
  switch (format) {
    case CalibrationFormat::cps:
      return "calibration.json";
    case CalibrationFormat::opencv_yaml:
      return "calibration.yml";
    case CalibrationFormat::opencv_xml:
      return "calibration.xml";
    case CalibrationFormat::colmap:
      return "cameras.txt";
    case CalibrationFormat::ros:
      return "camera_info.yaml";
    case CalibrationFormat::kitti:
      return "calib_cam_to_cam.txt";
    case CalibrationFormat::kalibr:
      return "camchain.yaml";
    case CalibrationFormat::nerfstudio:
      return "transforms.json";
  }
  return "";
}

std::vector<CalibratedCamera> read_calibration(const std::filesystem::path& file, ImageSize size) {
  const ModelCalibrationFile read = read_model_calibration_file(file, size);
  if (!read.unread.empty()) throw std::runtime_error(read.unread[0].fault);
  std::vector<CalibratedCamera> cameras;
  for (const ModelCamera& camera : read.cameras) cameras.push_back(brown_conrady(camera, file));
  return cameras;
}

CalibratedCamera read_camera(const std::filesystem::path& file, const std::string& name, ImageSize size) {
  return brown_conrady(read_model_camera(file, name, size), file);
}

void write_calibration(const std::filesystem::path& file, CalibrationFormat format,
                       std::span<const CalibratedCamera> cameras) {
  std::vector<ModelCamera> of_any_family;
  for (const CalibratedCamera& camera : cameras) of_any_family.push_back(model_camera(camera));
  write_model_calibration(file, format, of_any_family);
}

}  // namespace cps
