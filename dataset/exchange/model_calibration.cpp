#include "dataset/exchange/model_calibration.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "dataset/exchange/formats/formats.h"
#include "dataset/exchange/markup.h"
#include "dataset/exchange/plausible_camera.h"
#include "files/files.h"

namespace cps {
namespace {

ModelCalibrationFile only(ModelCamera camera) {
  return {.cameras = {std::move(camera)}};
}

bool has_cameras_inside(const nlohmann::json& json) {
  return std::any_of(json.begin(), json.end(), [](const nlohmann::json& value) {
    return value.is_object() && (value.contains("intrinsics") || value.contains("camera_model"));
  });
}

ModelCalibrationFile read_keys(const JsonKeys& root, const std::string& name) {
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
  named_lens(root, {NamedLens::plane});
  refuse_other_coefficients(root, {});
  throw std::runtime_error(root.file +
                           ": no calibration in it: expected K, fl_x, camera_matrix or cam0 at the top");
}

ModelCalibrationFile read_any(const std::string& text, const std::string& file, const std::string& name) {
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

/// Moves the cameras that cannot be to the unread ones.
void check_cameras(ModelCalibrationFile& file, const std::string& where, ImageSize size) {
  std::vector<ModelCamera> cameras;
  std::swap(cameras, file.cameras);
  for (ModelCamera& camera : cameras)
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

ModelCalibrationFile read_model_calibration_file(const std::filesystem::path& file, ImageSize size) try {
  ModelCalibrationFile read = read_any(text_of(file), file.string(), file.stem().string());
  check_cameras(read, file.string(), size);
  for (UnreadCamera& camera : read.unread) camera.fault = one_line(camera.fault);
  if (!read.cameras.empty()) return read;
  throw std::runtime_error(read.unread.empty() ? file.string() + ": has no camera in it"
                                               : read.unread[0].fault);
} catch (const std::runtime_error& error) {
  throw std::runtime_error(one_line(error.what()));
}

ModelCamera read_model_camera(const std::filesystem::path& file, const std::string& name, ImageSize size) {
  const ModelCalibrationFile read = read_model_calibration_file(file, size);
  std::string names;
  for (const ModelCamera& camera : read.cameras) {
    if (camera.name == name) return camera;
    names += " " + camera.name;
  }
  for (const UnreadCamera& camera : read.unread) {
    if (camera.name == name) throw std::runtime_error(camera.fault);
    names += " " + camera.name;
  }
  if (name.empty() && read.cameras.size() + read.unread.size() == 1) return read.cameras[0];
  throw std::runtime_error(one_line(
      file.string() + ": camera: " + (name.empty() ? "choose one of" : "'" + name + "' is none of") + names));
}

}  // namespace cps
