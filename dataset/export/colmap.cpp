#include <fmt/format.h>

#include "dataset/exchange/calibration_file.h"
#include "dataset/export/posed_images.h"
#include "files/files.h"

/// COLMAP's text model, one a condition: <condition>/sparse/0/cameras.txt, images.txt and points3D.txt, with
/// the images below <condition>/images. A camera is a group. COLMAP's camera looks as ours does (x right, y
/// down, z forward); its poses run the other way round, from the world to the camera.
namespace cps {
namespace {

/// Writes a camera for each group that the images belong to. Returns their ids by group.
std::map<int, int> write_cameras(const ExportJob& job, const std::string& folder,
                                 const std::vector<const DatasetImage*>& images) {
  std::map<int, int> ids;
  for (const DatasetImage* image : images) ids[image->group] = 0;
  std::vector<CalibratedCamera> cameras;
  for (auto& [group, id] : ids) {
    id = static_cast<int>(cameras.size()) + 1;
    cameras.push_back(calibrated_camera(job.source.dataset().groups[group].label, std::to_string(id)));
  }
  write_calibration(job.folder.at(folder) / "cameras.txt", CalibrationFormat::colmap, cameras);
  return ids;
}

/// The two lines of an image; the second one would list the points that it sees.
std::string image_lines(std::size_t id, int camera_id, const FrameRow& frame, const DatasetImage& image) {
  const Eigen::Isometry3d camera_from_world = world_from_camera(frame).inverse();
  Eigen::Quaterniond q(camera_from_world.linear());
  if (q.w() < 0) q.coeffs() *= -1;
  const Eigen::Vector3d t = camera_from_world.translation();
  return fmt::format("{} {} {} {} {} {} {} {} {} {}\n\n", id, q.w(), q.x(), q.y(), q.z(), t.x(), t.y(), t.z(),
                     camera_id, image.file.generic_string());
}

void write_model(const ExportJob& job, const std::string& folder,
                 const std::vector<const DatasetImage*>& images) {
  const std::map<int, int> camera_ids = write_cameras(job, folder, images);
  job.folder.write(folder + "/images.txt", [&](const Append& append) {
    append(std::string("# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n# POINTS2D[]: none\n"));
    for (std::size_t i = 0; i < images.size(); ++i)
      append(
          image_lines(i + 1, camera_ids.at(images[i]->group), job.source.frame_of(*images[i]), *images[i]));
  });
  write_file(job.folder.at(folder) / "points3D.txt",
             std::string("# POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[]: none\n"));
}

}  // namespace

void export_colmap(const ExportJob& job) {
  for (const DatasetImage& image : job.source.dataset().images)
    if (image.file.native().find_first_of(" \t") != std::string::npos)
      throw std::runtime_error(image.file.string() +
                               ": COLMAP reads no names with spaces: rename the rig's camera");
  for (const auto& [condition, images] : images_by_condition(job.source)) {
    add_condition_images(job, condition_folder(condition), images);
    write_model(job, condition_folder(condition) + "/sparse/0", images);
  }
}

}  // namespace cps
