#include <fmt/format.h>

#include <cctype>
#include <map>
#include <sstream>
#include <stdexcept>

#include "dataset/exchange/formats/formats.h"
#include "dataset/exchange/markup.h"

/// KITTI's calib_cam_to_cam.txt: S_xx (size), K_xx and D_xx (k1 k2 p1 p2 k3) of the unrectified cameras.
namespace cps {
namespace {

using Lines = std::map<std::string, std::string>;

/// The lines `key: value`. Throws if a key appears twice.
Lines lines_of(const std::string& text, const std::string& file) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t colon = line.find(':');
    if (colon == std::string::npos || line[0] == '#') continue;
    if (!lines.emplace(line.substr(0, colon), line.substr(colon + 1)).second)
      throw std::runtime_error(file + ": " + line.substr(0, colon) + ": appears twice: keep one");
  }
  return lines;
}

std::vector<double> numbers(const Lines& lines, const std::string& key, std::size_t count,
                            const std::string& file) {
  const auto line = lines.find(key);
  if (line == lines.end()) throw std::runtime_error(file + ": " + key + ": is missing");
  nlohmann::json list = nlohmann::json::array();
  std::istringstream words(line->second);
  for (std::string word; words >> word;) list.push_back(scalar(word));
  return number_list(list, count, file + ": " + key);
}

/// Whether a line of the text begins with `start` and a digit.
bool has_line(const std::string& text, const std::string& start) {
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (line.starts_with(start) && line.size() > start.size() &&
        std::isdigit(static_cast<unsigned char>(line[start.size()])) != 0 &&
        line.find(':') != std::string::npos)
      return true;
  return false;
}

}  // namespace

bool is_kitti(const std::string& text) {
  return has_line(text, "K_");
}

bool is_kitti_odometry(const std::string& text) {
  return has_line(text, "P");
}

ModelCalibrationFile read_kitti(const std::string& text, const std::string& file) {
  const Lines lines = lines_of(text, file);
  ModelCalibrationFile result;
  for (const auto& [key, value] : lines) {
    if (!key.starts_with("K_")) continue;
    const std::string name = key.substr(2);
    add_camera(result, name, [&]() -> ModelCamera {
      const std::vector<double> size = numbers(lines, "S_" + name, 2, file);
      const std::string where = file + ": S_" + name;
      return {name,
              pinhole_from_k(numbers(lines, key, 9, file), size_px(size[0], where), size_px(size[1], where),
                             file + ": " + key),
              brown_conrady_lens(numbers(lines, "D_" + name, 5, file), file + ": D_" + name)};
    });
  }
  return result;
}

ModelCalibrationFile read_kitti_odometry(const std::string& text, const std::string& file) {
  const Lines lines = lines_of(text, file);
  ModelCalibrationFile result;
  for (const auto& [key, value] : lines) {
    if (key.size() != 2 || key[0] != 'P') continue;
    add_camera(result, key, [&]() -> ModelCamera {
      const std::vector<double> p = numbers(lines, key, 12, file);
      return {key,
              pinhole_from_k(std::vector{p[0], p[1], p[2], p[4], p[5], p[6], p[8], p[9], p[10]}, 0, 0,
                             file + ": " + key),
              {}};
    });
  }
  return result;
}

std::string write_kitti(CameraSpan cameras) {
  const auto is_kitti_name = [](const std::string& name) {
    return name.size() == 2 && name.find_first_not_of("0123456789") == std::string::npos;
  };
  bool keep_names = true;
  for (const ModelCamera& camera : cameras) keep_names = keep_names && is_kitti_name(camera.name);
  std::string text;
  int index = 0;
  for (const ModelCamera& camera : cameras) {
    const std::string name = keep_names ? camera.name : fmt::format("{:02}", index);
    ++index;
    text += fmt::format("S_{0}: {1} {2}\nK_{0}: {3}\nD_{0}: {4}\n", name, camera.pinhole.width,
                        camera.pinhole.height, decimals(k_matrix(camera.pinhole), " "),
                        decimals(opencv_coefficients(camera.lens), " "));
  }
  return text;
}

}  // namespace cps
