#include "apps/train/camera_files.h"

#include <iostream>
#include <stdexcept>

#include "dataset/exchange/model_calibration.h"

namespace cps {

std::vector<CalibrationFormat> formats_of_word(const std::string& word) {
  if (word == "all") return {calibration_formats().begin(), calibration_formats().end()};
  try {
    return {calibration_format_from_string(word)};
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(std::string(error.what()) + ", all");
  }
}

void write_camera_files(const std::filesystem::path& folder, const std::string& prefix,
                        std::span<const CalibrationFormat> formats, const ModelCamera& camera) {
  for (CalibrationFormat format : formats) {
    const std::filesystem::path file = folder / (prefix + usual_file_name(format));
    if (formats.size() > 1 && !can_hold(format, camera.lens))
      std::cout << "left out: " << file.string() << ": the format " << to_string(format)
                << " cannot say this lens\n";
    else
      write_model_calibration(file, format, std::vector{camera});
  }
}

}  // namespace cps
