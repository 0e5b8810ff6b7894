#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "dataset/exchange/calibration_file.h"
#include "dataset/export/posed_images.h"

/// KITTI's raw data, not rectified. There a calibration belongs to a date, so a group is a date's folder with
/// its calib_cam_to_cam.txt, and each part of its images a drive: <group>_drive_<part>_extract/image_02/data.
namespace cps {
namespace {

namespace fs = std::filesystem;

constexpr const char* colour_camera = "02";

/// The group's folder without a separator.
std::string date_of(const DatasetGroup& group) {
  std::string name = group.folder.generic_string();
  std::ranges::replace(name, '/', '_');
  return name;
}

/// KITTI numbers frames with ten digits; the number stays what it is in the dataset, where one number in two
/// groups is one view.
std::string frame_name(const DatasetImage& image) {
  const std::string number = image.file.stem().string();
  if (number.empty() || number.size() > 10 || number.find_first_not_of("0123456789") != std::string::npos)
    throw std::runtime_error(image.file.string() +
                             ": KITTI's frames are numbers of up to ten digits: rename the image");
  return fmt::format("{:0>10}{}", number, image.file.extension().string());
}

}  // namespace

void export_kitti(const ExportJob& job) {
  for (const DatasetImage& image : job.source.dataset().images) {
    const std::string date = date_of(job.source.group_of(image));
    const std::string drive = fmt::format("{}_drive_{}_extract", date, to_string(image.part));
    job.folder.add_image(
        job.source, image,
        fs::path(date) / drive / fmt::format("image_{}", colour_camera) / "data" / frame_name(image));
    job.progress(1, image.file.string());
  }
  for (const DatasetGroup& group : job.source.dataset().groups)
    write_calibration(job.folder.at(date_of(group)) / "calib_cam_to_cam.txt", CalibrationFormat::kitti,
                      std::vector{calibrated_camera(group.label, colour_camera)});
}

}  // namespace cps
