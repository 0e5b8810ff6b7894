#include "dataset/exchange/camera_pictures.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>

#include "dataset/dense/dense_file.h"
#include "dataset/exchange/calibration_file.h"
#include "dataset/labels/valid_mask.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

bool is_picture_name(const fs::path& file) {
  static constexpr std::array names{".png", ".jpg",  ".jpeg", ".tif", ".tiff",
                                    ".bmp", ".webp", ".ppm",  ".pgm"};
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return std::ranges::find(names, extension) != names.end();
}

/// Whether it is what a dataset keeps of its images' pixels beside them.
bool is_pixel_label(const fs::path& file) {
  return is_dense_file(file) ||
         (file.filename() == valid_mask_file && fs::exists(file.parent_path() / "calibration.json"));
}

std::vector<fs::path> pictures_or_none(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_regular_file() && is_picture_name(entry.path()) && !is_pixel_label(entry.path()))
      files.push_back(entry.path());
  std::ranges::sort(files);
  return files;
}

std::vector<fs::path> subfolders(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_directory()) found.push_back(entry.path());
  std::ranges::sort(found);
  return found;
}

/// Folders that hold a calib_cam_to_cam.txt: `root`, or those one below it.
std::vector<fs::path> kitti_dates(const fs::path& root) {
  if (fs::exists(root / "calib_cam_to_cam.txt")) return {root};
  std::vector<fs::path> dates;
  for (const fs::path& folder : subfolders(root))
    if (fs::exists(folder / "calib_cam_to_cam.txt")) dates.push_back(folder);
  return dates;
}

}  // namespace

std::vector<CameraPictures> kitti_raw(const fs::path& folder) {
  if (!fs::is_directory(folder))
    throw std::runtime_error(folder.string() + ": is not a folder; name that of KITTI's raw data");
  const std::vector<fs::path> dates = kitti_dates(folder);
  if (dates.empty())
    throw std::runtime_error((folder / "calib_cam_to_cam.txt").string() +
                             ": is missing, here and one folder down: name the folder of a date");
  std::vector<CameraPictures> cameras;
  for (const fs::path& date : dates)
    for (const CalibratedCamera& camera : read_calibration(date / "calib_cam_to_cam.txt")) {
      CameraPictures pictures{camera, {}};
      for (const fs::path& drive : subfolders(date)) {
        const fs::path frames = drive / ("image_" + camera.name) / "data";
        if (!fs::is_directory(frames)) continue;
        const std::vector<fs::path> of_drive = pictures_or_none(frames);
        pictures.files.insert(pictures.files.end(), of_drive.begin(), of_drive.end());
      }
      if (!pictures.files.empty()) cameras.push_back(std::move(pictures));
    }
  if (cameras.empty())
    throw std::runtime_error(folder.string() +
                             ": holds no <drive>/image_00/data/*.png: name the folder above the drives");
  return cameras;
}

std::vector<fs::path> pictures_in(const fs::path& folder) {
  if (!fs::is_directory(folder)) throw std::runtime_error(folder.string() + ": is not a folder of pictures");
  std::vector<fs::path> files = pictures_or_none(folder);
  if (files.empty()) throw std::runtime_error(folder.string() + ": has no pictures in it");
  return files;
}

}  // namespace cps
