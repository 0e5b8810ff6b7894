#include <fmt/format.h>

#include <map>
#include <sstream>
#include <stdexcept>

#include "dataset/exchange/formats.h"
#include "dataset/exchange/markup.h"

/// KITTI's calib_cam_to_cam.txt: S_xx (size), K_xx and D_xx (k1 k2 p1 p2 k3) of the unrectified cameras.
namespace cps {
namespace {

std::vector<double> numbers(const std::map<std::string, std::string>& lines, const std::string& key,
                            std::size_t count, const std::string& file) {
  const auto line = lines.find(key);
  if (line == lines.end()) throw std::runtime_error(file + ": " + key + ": is missing");
  std::vector<double> values;
  std::istringstream words(line->second);
  for (std::string word; words >> word;) {
    const nlohmann::json value = scalar(word);
    if (!value.is_number()) throw std::runtime_error(file + ": " + key + ": '" + word + "' is not a number");
    values.push_back(value);
  }
  if (values.size() != count)
    throw std::runtime_error(file + ": " + key + ": must be " + std::to_string(count) + " numbers");
  return values;
}

}  // namespace

Cameras read_kitti(const std::string& text, const std::string& file) {
  std::map<std::string, std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    if (const std::size_t colon = line.find(':'); colon != std::string::npos)
      lines[line.substr(0, colon)] = line.substr(colon + 1);
  Cameras cameras;
  for (const auto& [key, value] : lines) {
    if (!key.starts_with("K_")) continue;
    const std::string name = key.substr(2);
    const std::vector<double> size = numbers(lines, "S_" + name, 2, file);
    if (!(size[0] >= 1 && size[0] <= 1 << 20 && size[1] >= 1 && size[1] <= 1 << 20))
      throw std::runtime_error(file + ": S_" + name + ": must be two sizes in pixels");
    cameras.push_back({name,
                       pinhole_from_k(numbers(lines, key, 9, file), static_cast<int>(size[0]),
                                      static_cast<int>(size[1]), file + ": " + key),
                       from_opencv_order(numbers(lines, "D_" + name, 5, file), file + ": D_" + name)});
  }
  return cameras;
}

std::string write_kitti(CameraSpan cameras) {
  const auto is_kitti_name = [](const std::string& name) {
    return name.size() == 2 && name.find_first_not_of("0123456789") == std::string::npos;
  };
  bool keep_names = true;
  for (const CalibratedCamera& camera : cameras) keep_names = keep_names && is_kitti_name(camera.name);
  std::string text;
  int index = 0;
  for (const CalibratedCamera& camera : cameras) {
    const std::string name = keep_names ? camera.name : fmt::format("{:02}", index);
    ++index;
    text += fmt::format("S_{0}: {1} {2}\nK_{0}: {3}\nD_{0}: {4}\n", name, camera.pinhole.width,
                        camera.pinhole.height, decimals(k_matrix(camera.pinhole), " "),
                        decimals(in_opencv_order(camera.distortion), " "));
  }
  return text;
}

}  // namespace cps
