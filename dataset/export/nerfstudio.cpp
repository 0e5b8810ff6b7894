#include <array>

#include "dataset/exchange/camera_json.h"
#include "dataset/exchange/formats/formats.h"
#include "dataset/export/posed_images.h"

/// Nerfstudio, one folder a condition: transforms.json and images/. A camera looks along −z with y up, and
/// the world's z points up: `applied_transform` is the turn from our world (y up) to that one.
namespace cps {
namespace {

using Json = nlohmann::ordered_json;

/// (x, y, z) becomes (x, −z, y).
Eigen::Matrix4d z_up_from_y_up() {
  Eigen::Matrix4d turn = Eigen::Matrix4d::Zero();
  turn(0, 0) = turn(2, 1) = turn(3, 3) = 1;
  turn(1, 2) = -1;
  return turn;
}

std::string path_of(const DatasetImage& image) {
  return "images/" + image.file.generic_string();
}

Json frame_json(const ExportSource& source, const DatasetImage& image) {
  const Eigen::Vector4d flipped(1, -1, -1, 1);  // our camera has y down and looks along +z
  const Eigen::Matrix4d pose = z_up_from_y_up() * world_from_camera(source.frame_of(image)).matrix();
  Json frame = {{"file_path", path_of(image)}};
  frame.update(nerfstudio_camera(calibrated_camera(source.label_of(image), "")));
  frame["transform_matrix"] = rows_json(pose * flipped.asDiagonal());
  return frame;
}

/// The names of a part's images, one a line, as the elements of a JSON list.
void append_names(const Append& append, Part part, const std::vector<const DatasetImage*>& images) {
  std::string separator = "\n";
  for (const DatasetImage* image : images)
    if (image->part == part) {
      append(separator + Json(path_of(*image)).dump());
      separator = ",\n";
    }
}

/// Piece by piece: as one object in memory it would be larger than the dataset's other tables together.
void write_transforms(const ExportJob& job, const std::string& folder,
                      const std::vector<const DatasetImage*>& images) {
  job.folder.write(folder + "/transforms.json", [&](const Append& append) {
    append("{\"camera_model\": \"OPENCV\",\n\"applied_transform\": " +
           rows_json(z_up_from_y_up().topRows(3)).dump() + ",\n\"frames\": [");
    std::string separator = "\n";
    for (const DatasetImage* image : images) {
      append(separator + frame_json(job.source, *image).dump());
      separator = ",\n";
    }
    for (Part part : {Part::train, Part::val, Part::test}) {
      append("],\n\"" + to_string(part) + "_filenames\": [");
      append_names(append, part, images);
    }
    append(std::string("]}\n"));
  });
}

}  // namespace

void export_nerfstudio(const ExportJob& job) {
  for (const auto& [condition, images] : images_by_condition(job.source)) {
    add_condition_images(job, condition_folder(condition), images);
    write_transforms(job, condition_folder(condition), images);
  }
}

}  // namespace cps
