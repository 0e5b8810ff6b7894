#include "dataset/exchange/calibration_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "dataset/exchange/formats/formats.h"
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

/// Throws for a camera that no lens and no sensor can be, whatever the format. Limits are far outside what
/// exists: the product of a coefficient and its power of the frame's radius moves a corner by that many
/// radii.
void check_plausible(const CalibratedCamera& calibrated, const std::string& where) {
  constexpr int max_side_px = 100'000;
  constexpr double max_coefficient = 100, max_focal_in_widths = 1000;
  const auto& [width, height, fx, fy, cx, cy] = calibrated.pinhole;
  const Distortion& lens = calibrated.distortion;
  if (width < 1 || height < 1 || width > max_side_px || height > max_side_px)
    throw std::runtime_error(where + ": width, height: must lie between 1 and 100000 pixels");
  if (!(fx > 0 && fy > 0 && std::isfinite(fx) && std::isfinite(fy)))
    throw std::runtime_error(where + ": fx, fy: must be positive and finite");
  const double longest = std::max(width, height);
  if (std::max(fx, fy) > max_focal_in_widths * longest || std::min(fx, fy) < longest / max_focal_in_widths)
    throw std::runtime_error(where + ": fx, fy: beyond any lens: must be focal lengths in pixels");
  if (!(cx > -0.5 && cx < width - 0.5 && cy > -0.5 && cy < height - 0.5))
    throw std::runtime_error(where + ": cx, cy: the principal point lies outside the image");
  for (double value : {lens.k1, lens.k2, lens.k3, lens.p1, lens.p2})
    if (!std::isfinite(value)) throw std::runtime_error(where + ": k1 k2 p1 p2 k3: must be finite");
  const double r2 = std::pow(0.5 * width / fx, 2) + std::pow(0.5 * height / fy, 2), r = std::sqrt(r2);
  const std::pair<const char*, double> scaled[] = {{"k1", lens.k1 * r2},
                                                   {"k2", lens.k2 * r2 * r2},
                                                   {"k3", lens.k3 * r2 * r2 * r2},
                                                   {"p1", lens.p1 * r},
                                                   {"p2", lens.p2 * r}};
  for (const auto& [name, value] : scaled)
    if (std::abs(value) > max_coefficient)
      throw std::runtime_error(where + ": " + name +
                               ": beyond any lens: check its unit and its order in the file");
}

CalibrationFile only(CalibratedCamera camera) {
  return {.cameras = {std::move(camera)}};
}

bool has_cameras_inside(const nlohmann::json& json) {
  return std::any_of(json.begin(), json.end(), [](const nlohmann::json& value) {
    return value.is_object() && (value.contains("intrinsics") || value.contains("camera_model"));
  });
}

CalibrationFile read_keys(const JsonKeys& root, const std::string& name) {
  const auto has = [&](const char* key) { return root.json.contains(key); };
  if ((has("K") && has("D")) || (has("k") && has("d"))) return only(read_ros_message(root, name));
  if (has("K")) return only(read_cps(root, name));
  if (has("fl_x") || has("frames")) return read_nerfstudio(root, name);
  if (is_orbslam(root.json)) return read_orbslam(root);
  if (has("projection_parameters") || has("model_type")) return only(read_vins(root, name));
  if (has("intrinsics") && has("resolution")) return only(read_euroc(root, name));
  if (has("distortion_model") && has("camera_matrix")) return only(read_ros(root, name));
  if (is_opencv(root.json)) return only(read_opencv(root, name));
  if (has_cameras_inside(root.json)) return read_kalibr(root);
  refuse_other_models(root, {});
  throw std::runtime_error(root.file +
                           ": no calibration in it: expected K, fl_x, camera_matrix or cam0 at the top");
}

CalibrationFile read_any(const std::string& text, const std::string& file, const std::string& name) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string::npos) throw std::runtime_error(file + ": is empty");
  if (text[start] == '<') {
    const nlohmann::json json = json_from_xml(text, file);
    const JsonKeys root{json, file};
    return only(json.contains("f") ? read_metashape(root, name) : read_opencv(root, name));
  }
  if (text[start] == '{') {
    const nlohmann::json json = json_from_json(text, file);
    return read_keys({json, file}, name);
  }
  if (is_kitti(text)) return read_kitti(text, file);
  if (is_kitti_odometry(text)) return read_kitti_odometry(text, file);
  if (file.ends_with(".txt")) return read_colmap(text, file);
  const nlohmann::json json = json_from_yaml(text, file);
  if (!json.is_object()) throw std::runtime_error(file + ": is no calibration format that cps knows");
  return read_keys({json, file}, name);
}

/// The file's text without a byte order mark.
std::string text_of(const std::filesystem::path& file) {
  constexpr std::uintmax_t max_bytes = 64 << 20;
  std::error_code error;
  if (std::filesystem::file_size(file, error) > max_bytes && !error)
    throw std::runtime_error(file.string() + ": is larger than 64 MiB, so no calibration");
  std::string text = read_file(file);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw std::runtime_error(file.string() + ": is UTF-16 text: save it as UTF-8");
  return text;
}

/// Messages quote the file, whose values may hold line breaks.
std::string one_line(std::string text) {
  std::ranges::replace_if(
      text, [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return text;
}

/// Moves the cameras that cannot be to the unread ones.
void check_cameras(CalibrationFile& file, const std::string& where, ImageSize size) {
  std::vector<CalibratedCamera> cameras;
  std::swap(cameras, file.cameras);
  for (CalibratedCamera& camera : cameras)
    add_camera(file, camera.name, [&] {
      if (camera.pinhole.width == 0) {
        if (size == ImageSize{0, 0})
          throw std::runtime_error(where + ": " + camera.name +
                                   ": the file does not say the pictures' size: give --size");
        camera.pinhole.width = size.width;
        camera.pinhole.height = size.height;
      }
      check_plausible(camera, where + ": " + camera.name);
      return camera;
    });
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

CalibrationFile read_calibration_file(const std::filesystem::path& file, ImageSize size) try {
  CalibrationFile read = read_any(text_of(file), file.string(), file.stem().string());
  check_cameras(read, file.string(), size);
  for (UnreadCamera& camera : read.unread) camera.fault = one_line(camera.fault);
  if (!read.cameras.empty()) return read;
  throw std::runtime_error(read.unread.empty() ? file.string() + ": has no camera in it"
                                               : read.unread[0].fault);
} catch (const std::runtime_error& error) {
  throw std::runtime_error(one_line(error.what()));
}

std::vector<CalibratedCamera> read_calibration(const std::filesystem::path& file, ImageSize size) {
  CalibrationFile read = read_calibration_file(file, size);
  if (!read.unread.empty()) throw std::runtime_error(read.unread[0].fault);
  return std::move(read.cameras);
}

CalibratedCamera read_camera(const std::filesystem::path& file, const std::string& name, ImageSize size) {
  const CalibrationFile read = read_calibration_file(file, size);
  std::string names;
  for (const CalibratedCamera& camera : read.cameras) {
    if (camera.name == name) return camera;
    names += " " + camera.name;
  }
  for (const UnreadCamera& camera : read.unread) {
    if (camera.name == name) throw std::runtime_error(camera.fault);
    names += " " + camera.name;
  }
  if (name.empty() && read.cameras.size() + read.unread.size() == 1) return read.cameras[0];
  throw std::runtime_error(
      file.string() + ": camera: " + (name.empty() ? "choose one of" : "'" + name + "' is none of") + names);
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

}  // namespace cps
