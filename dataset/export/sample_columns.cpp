#include "dataset/export/sample_columns.h"

#include <array>

#include "numbers/angles.h"

namespace cps {
namespace {

using Json = nlohmann::ordered_json;

/// A column of the label that the images of a group share.
template <typename Member>
constexpr SampleColumn of_label(const char* name, ColumnType type, const char* meaning, Member) {
  return {name, type, meaning, false, [](const ExportSource& source, const DatasetImage& image) -> Json {
            return Member{}(source.label_of(image));
          }};
}

/// A column of the image's line in frames.csv.
template <typename Member>
constexpr SampleColumn of_frame(const char* name, ColumnType type, const char* meaning, Member) {
  return {name, type, meaning, true, [](const ExportSource& source, const DatasetImage& image) -> Json {
            return Member{}(source.frame_of(image));
          }};
}

constexpr ColumnType text = ColumnType::text, integer = ColumnType::integer, number = ColumnType::number;

constexpr std::array columns = {
    SampleColumn{
        "file", text, "the image in the dataset that this was exported from", false,
        [](const ExportSource&, const DatasetImage& image) -> Json { return image.file.generic_string(); }},
    SampleColumn{"group", text, "images of one group share everything up to fov_true_d_deg", false,
                 [](const ExportSource& source, const DatasetImage& image) -> Json {
                   return source.group_of(image).folder.generic_string();
                 }},
    of_label("camera", text, "name of the rig camera", [](auto& l) { return l.rig_camera; }),
    of_label("width", integer, "pixels", [](auto& l) { return l.camera.width; }),
    of_label("height", integer, "pixels", [](auto& l) { return l.camera.height; }),
    of_label("fov", number, "horizontal field of view of the label, 2 atan(width / 2 fx), degrees",
             [](auto& l) { return degrees(hfov_rad(l.camera)); }),
    of_label("k1", number, "radial distortion, r^2", [](auto& l) { return l.distortion.k1; }),
    of_label("k2", number, "radial distortion, r^4", [](auto& l) { return l.distortion.k2; }),
    of_label("k3", number, "radial distortion, r^6", [](auto& l) { return l.distortion.k3; }),
    of_label("p1", number, "tangential distortion", [](auto& l) { return l.distortion.p1; }),
    of_label("p2", number, "tangential distortion", [](auto& l) { return l.distortion.p2; }),
    of_label("cx", number, "principal point, pixels; the top-left pixel's centre is (0, 0)",
             [](auto& l) { return l.camera.cx; }),
    of_label("cy", number, "principal point, pixels; the top-left pixel's centre is (0, 0)",
             [](auto& l) { return l.camera.cy; }),
    of_label("fx", number, "focal length, pixels", [](auto& l) { return l.camera.fx; }),
    of_label("fy", number, "focal length, pixels; equals fx", [](auto& l) { return l.camera.fy; }),
    of_label("fov_true_h_deg", number, "angle that the distorted image shows along its row, degrees",
             [](auto& l) { return l.fov_true_h_deg; }),
    of_label("fov_true_v_deg", number, "angle that it shows along its column, degrees",
             [](auto& l) { return l.fov_true_v_deg; }),
    of_label("fov_true_d_deg", number, "angle that it shows between opposite corners, degrees",
             [](auto& l) { return l.fov_true_d_deg; }),
    of_frame("condition", integer, "which scene, light and weather", [](auto& f) { return f.condition; }),
    of_frame("street", text, "name of the street", [](auto& f) { return f.street; }),
    of_frame("camera_x_m", number, "position in the world (y up), metres",
             [](auto& f) { return f.camera_position.x(); }),
    of_frame("camera_y_m", number, "position in the world (y up), metres",
             [](auto& f) { return f.camera_position.y(); }),
    of_frame("camera_z_m", number, "position in the world (y up), metres",
             [](auto& f) { return f.camera_position.z(); }),
    of_frame("camera_qw", number,
             "orientation, world from camera (x right, y down, z forward), unit quaternion",
             [](auto& f) { return f.camera_rotation.w(); }),
    of_frame("camera_qx", number, "orientation", [](auto& f) { return f.camera_rotation.x(); }),
    of_frame("camera_qy", number, "orientation", [](auto& f) { return f.camera_rotation.y(); }),
    of_frame("camera_qz", number, "orientation", [](auto& f) { return f.camera_rotation.z(); }),
    of_frame("gravity_x", number,
             "gravity in the camera's frame (x right, y down, z forward), unit vector downwards",
             [](auto& f) { return f.gravity.x(); }),
    of_frame("gravity_y", number, "gravity", [](auto& f) { return f.gravity.y(); }),
    of_frame("gravity_z", number, "gravity", [](auto& f) { return f.gravity.z(); }),
    of_frame("sha256", text, "hash of the image's file", [](auto& f) { return f.sha256; }),
};

void add_columns(Json& json, const ExportSource& source, const DatasetImage& image) {
  for (const SampleColumn& column : columns)
    if (!column.needs_frame || source.has_frames()) json[column.name] = column.value(source, image);
}

}  // namespace

std::vector<SampleColumn> sample_columns(const ExportSource& source) {
  std::vector<SampleColumn> used(columns.begin(), columns.end());
  if (!source.has_frames()) std::erase_if(used, [](const SampleColumn& c) { return c.needs_frame; });
  return used;
}

nlohmann::ordered_json sample_json(const ExportSource& source, const DatasetImage& image) {
  Json json;
  add_columns(json, source, image);
  return json;
}

std::string metadata_line(const ExportSource& source, const DatasetImage& image) {
  Json json = {{"file_name", image.file.generic_string()}};
  add_columns(json, source, image);
  return json.dump() + "\n";
}

}  // namespace cps
