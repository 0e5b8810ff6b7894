#include "dataset/exchange/calibration_file.h"

#include <array>
#include <cmath>
#include <stdexcept>

#include "dataset/exchange/formats.h"
#include "dataset/exchange/markup.h"
#include "files/files.h"

namespace cps {
namespace {

struct Writer {
  CalibrationFormat format;
  const char* name;
  std::string (*write)(CameraSpan);
};
constexpr std::array<Writer, 8> writers{{{CalibrationFormat::cps, "cps", write_cps},
                                         {CalibrationFormat::opencv_yaml, "opencv-yaml", write_opencv_yaml},
                                         {CalibrationFormat::opencv_xml, "opencv-xml", write_opencv_xml},
                                         {CalibrationFormat::colmap, "colmap", write_colmap},
                                         {CalibrationFormat::ros, "ros", write_ros},
                                         {CalibrationFormat::kitti, "kitti", write_kitti},
                                         {CalibrationFormat::kalibr, "kalibr", write_kalibr},
                                         {CalibrationFormat::nerfstudio, "nerfstudio", write_nerfstudio}}};

/// Refuses numbers that no real camera has, whatever the format.
void check_plausible(const CalibratedCamera& calibrated, const std::string& where) {
  constexpr int largest_side = 100'000;
  const auto& [width, height, fx, fy, cx, cy] = calibrated.pinhole;
  const Distortion& lens = calibrated.distortion;
  if (width < 1 || height < 1 || width > largest_side || height > largest_side)
    throw std::runtime_error(where + ": width, height: must lie between 1 and 100000 pixels");
  if (!(fx > 0 && fy > 0 && std::isfinite(fx) && std::isfinite(fy)))
    throw std::runtime_error(where + ": fx, fy: must be positive and finite");
  if (!(cx > -0.5 && cx < width - 0.5 && cy > -0.5 && cy < height - 0.5))
    throw std::runtime_error(where + ": cx, cy: the principal point lies outside the image");
  for (double value : {lens.k1, lens.k2, lens.k3, lens.p1, lens.p2})
    if (!std::isfinite(value)) throw std::runtime_error(where + ": k1 k2 p1 p2 k3: must be finite");
}

Cameras read_keys(const JsonKeys& root, const std::string& name) {
  const auto has = [&](const char* key) { return root.json.contains(key); };
  if (has("K")) return read_cps(root, name);
  if (has("fl_x") || has("frames")) return read_nerfstudio(root, name);
  if (has("distortion_model") && has("camera_matrix")) return read_ros(root, name);
  if (has("camera_matrix")) return read_opencv(root, name);
  if (has("cam0")) return read_kalibr(root);
  throw std::runtime_error(root.file +
                           ": no calibration in it: expected K, fl_x, camera_matrix or cam0 at the top");
}

Cameras read_any(const std::string& text, const std::string& file, const std::string& name) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string::npos) throw std::runtime_error(file + ": is empty");
  if (text[start] == '<') {
    const nlohmann::json json = json_from_opencv_xml(text, file);
    return read_opencv({json, file}, name);
  }
  if (text[start] == '{') {
    const nlohmann::json json = read_json(file);
    return read_keys({json, file}, name);
  }
  if (text.find("K_0") != std::string::npos) return read_kitti(text, file);
  if (file.ends_with(".txt")) return read_colmap(text, file);
  const nlohmann::json json = json_from_yaml(text, file);
  if (!json.is_object()) throw std::runtime_error(file + ": is no calibration format that cps knows");
  return read_keys({json, file}, name);
}

}  // namespace

std::string to_string(CalibrationFormat format) {
  for (const Writer& writer : writers)
    if (writer.format == format) return writer.name;
  return {};
}

CalibrationFormat calibration_format_from_string(const std::string& name) {
  std::string known;
  for (const Writer& writer : writers) {
    if (writer.name == name) return writer.format;
    known += std::string(known.empty() ? "" : ", ") + writer.name;
  }
  throw std::runtime_error("format: '" + name + "' is none of " + known);
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

std::vector<CalibratedCamera> read_calibration(const std::filesystem::path& file) {
  Cameras cameras = read_any(read_file(file), file.string(), file.stem().string());
  if (cameras.empty()) throw std::runtime_error(file.string() + ": has no camera in it");
  for (const CalibratedCamera& camera : cameras) check_plausible(camera, file.string() + ": " + camera.name);
  return cameras;
}

void write_calibration(const std::filesystem::path& file, CalibrationFormat format,
                       std::span<const CalibratedCamera> cameras) try {
  for (const CalibratedCamera& camera : cameras) check_plausible(camera, camera.name);
  for (const Writer& writer : writers)
    if (writer.format == format) write_file(file, writer.write(cameras));
} catch (const std::runtime_error& error) {
  const std::string what = error.what();
  throw std::runtime_error(what.starts_with(file.string()) ? what : file.string() + ": " + what);
}

CalibratedCamera chosen_camera(const std::vector<CalibratedCamera>& cameras, const std::string& name,
                               const std::filesystem::path& file) {
  std::string names;
  for (const CalibratedCamera& camera : cameras) {
    if (camera.name == name || (name.empty() && cameras.size() == 1)) return camera;
    names += " " + camera.name;
  }
  throw std::runtime_error(
      file.string() + ": camera: " + (name.empty() ? "choose one of" : "'" + name + "' is none of") + names);
}

}  // namespace cps
