#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <set>
#include <sstream>

#include "dataset/exchange/calibration_file.h"
#include "dataset/exchange/camera_pictures.h"
#include "tests/dataset/export/exported.h"

using namespace cps;
namespace fs = std::filesystem;
using Json = nlohmann::json;

/// COLMAP, nerfstudio and KITTI: points of the world, projected by the formulas of these programs with the
/// numbers in their files, must fall where the product's own camera and lens put them.
namespace {

/// A dataset's image with its pose, by its name in the dataset.
struct Seen {
  Label label;
  FrameRow frame;
};

std::map<std::string, Seen> seen_by(const fs::path& root) {
  std::map<std::string, Seen> seen;
  for (const DatasetGroup& group : read_dataset(root).groups)
    for (const FrameRow& row : read_frames_csv(root / group.folder / "frames.csv"))
      seen[(group.folder / row.file).string()] = {group.label, row};
  return seen;
}

/// Points before a camera, in the world, with the pixels that the product gives them.
std::vector<std::pair<Eigen::Vector3d, Eigen::Vector2d>> points_of(const Seen& seen) {
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector2d>> points;
  const Pinhole& camera = seen.label.camera;
  for (double u : {0.1, 0.5, 0.8})
    for (double v : {0.2, 0.9}) {
      const Eigen::Vector2d ideal = to_plane(camera, {u * camera.width, v * camera.height});
      const double depth = 3 + 20 * u;
      points.emplace_back(world_from_camera(seen.frame) * Eigen::Vector3d(depth * ideal.homogeneous()),
                          to_pixel(camera, distort(seen.label.distortion, ideal)));
    }
  return points;
}

/// OPENCV and FULL_OPENCV of COLMAP, and nerfstudio's OPENCV, which are one model: k1 k2 p1 p2 k3 after
/// fx fy cx cy; (.5, .5) is the centre of the first pixel.
Eigen::Vector2d project(const std::vector<double>& parameters, double x, double y) {
  const auto at = [&](std::size_t i) { return i < parameters.size() ? parameters[i] : 0.0; };
  const double r2 = x * x + y * y;
  const double radial = 1 + at(4) * r2 + at(5) * r2 * r2 + at(8) * r2 * r2 * r2;
  const double dx = x * radial + 2 * at(6) * x * y + at(7) * (r2 + 2 * x * x);
  const double dy = y * radial + 2 * at(7) * x * y + at(6) * (r2 + 2 * y * y);
  return {at(0) * dx + at(2), at(1) * dy + at(3)};
}

struct ColmapCamera {
  std::string model;
  int width = 0, height = 0;
  std::vector<double> parameters;
};

std::map<int, ColmapCamera> colmap_cameras(const fs::path& file) {
  std::map<int, ColmapCamera> cameras;
  std::istringstream text(read_file(file));
  for (std::string line; std::getline(text, line);) {
    if (line.starts_with('#')) continue;
    std::istringstream words(line);
    int id = 0;
    ColmapCamera camera;
    words >> id >> camera.model >> camera.width >> camera.height;
    for (double value = 0; words >> value;) camera.parameters.push_back(value);
    cameras[id] = camera;
  }
  return cameras;
}

std::vector<fs::path> conditions_in(const fs::path& out) {
  std::vector<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(out))
    if (entry.is_directory()) folders.push_back(entry.path());
  return folders;
}

}  // namespace

TEST_CASE("points seen through COLMAP's cameras and poses fall where the product puts them") {
  const Exported exported(ExportTarget::colmap);
  std::map<std::string, Seen> seen = seen_by(exported.root);
  std::set<std::string> models;
  for (const fs::path& condition : conditions_in(exported.out)) {
    const std::map<int, ColmapCamera> cameras = colmap_cameras(condition / "sparse/0/cameras.txt");
    std::istringstream text(read_file(condition / "sparse/0/images.txt"));
    for (std::string line, points; std::getline(text, line);) {
      if (line.starts_with('#')) continue;
      std::getline(text, points);
      CHECK(points.empty());
      std::istringstream words(line);
      int id = 0, camera_id = 0;
      double qw = 0, qx = 0, qy = 0, qz = 0, tx = 0, ty = 0, tz = 0;
      std::string name;
      words >> id >> qw >> qx >> qy >> qz >> tx >> ty >> tz >> camera_id >> name;
      INFO(name);
      REQUIRE(seen.contains(name));
      CHECK(fs::exists(condition / "images" / name));
      const ColmapCamera& camera = cameras.at(camera_id);
      models.insert(camera.model);
      CHECK(camera.parameters.size() == (camera.model == "OPENCV" ? 8 : 12));
      CHECK((seen[name].label.distortion.k3 == 0) == (camera.model == "OPENCV"));
      for (const auto& [world, pixel] : points_of(seen[name])) {
        // A rotation by a quaternion, written out.
        const Eigen::Vector3d axis(qx, qy, qz), turned = 2 * axis.cross(world);
        const Eigen::Vector3d p = world + qw * turned + axis.cross(turned) + Eigen::Vector3d(tx, ty, tz);
        REQUIRE(p.z() > 0);
        const Eigen::Vector2d found = project(camera.parameters, p.x() / p.z(), p.y() / p.z());
        CHECK((found - Eigen::Vector2d(.5, .5) - pixel).norm() < 1e-8);
      }
      seen.erase(name);
    }
  }
  CHECK(seen.empty());
  CHECK(models == std::set<std::string>{"FULL_OPENCV", "OPENCV"});
}

TEST_CASE("the product's own reader finds each label in COLMAP's cameras.txt") {
  const Exported exported(ExportTarget::colmap);
  std::size_t cameras = 0;
  for (const fs::path& condition : conditions_in(exported.out))
    for (const CalibratedCamera& camera : read_calibration(condition / "sparse/0/cameras.txt")) {
      const auto is_same = [&](const DatasetGroup& group) {
        return group.label.distortion == camera.distortion && group.label.camera.fx == camera.pinhole.fx &&
               std::abs(group.label.camera.cx - camera.pinhole.cx) < 1e-12;
      };
      const Dataset dataset = read_dataset(exported.root);
      CHECK(std::ranges::any_of(dataset.groups, is_same));
      ++cameras;
    }
  CHECK(cameras >= exported.plan.groups.size());
}

TEST_CASE("points seen through nerfstudio's frames fall where the product puts them") {
  const Exported exported(ExportTarget::nerfstudio);
  std::map<std::string, Seen> seen = seen_by(exported.root);
  for (const fs::path& condition : conditions_in(exported.out)) {
    const Json json = read_json(condition / "transforms.json");
    CHECK(json.at("camera_model") == "OPENCV");
    CHECK(json.at("applied_transform") == Json::parse("[[1.0,0,0,0],[0,0,-1.0,0],[0,1.0,0,0]]"));
    std::map<std::string, std::string> part_of;
    for (const char* part : {"train", "val", "test"})
      for (const Json& name : json.at(std::string(part) + "_filenames")) part_of[name] = part;
    CHECK(part_of.size() == json.at("frames").size());
    for (const Json& frame : json.at("frames")) {
      const std::string path = frame.at("file_path"), name = path.substr(std::string("images/").size());
      INFO(name);
      REQUIRE(seen.contains(name));
      CHECK(fs::exists(condition / path));
      CHECK(part_of[path] == to_string(seen[name].frame.part));
      CHECK(frame.at("w") == seen[name].label.camera.width);
      Eigen::Matrix4d pose;
      for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) pose(r, c) = frame.at("transform_matrix")[r][c];
      CHECK(std::abs(pose.topLeftCorner<3, 3>().determinant() - 1) < 1e-12);
      std::vector<double> parameters;
      for (const char* key : {"fl_x", "fl_y", "cx", "cy", "k1", "k2", "p1", "p2", "k3"})
        parameters.push_back(frame.at(key));
      for (const auto& [world, pixel] : points_of(seen[name])) {
        const Eigen::Vector4d z_up(world.x(), -world.z(), world.y(), 1), p = pose.inverse() * z_up;
        REQUIRE(p.z() < 0);  // OpenGL's camera looks along −z, its y is up
        const Eigen::Vector2d found = project(parameters, p.x() / -p.z(), -p.y() / -p.z());
        CHECK((found - Eigen::Vector2d(.5, .5) - pixel).norm() < 1e-8);
      }
      seen.erase(name);
    }
  }
  CHECK(seen.empty());
}

TEST_CASE("the cameras of nerfstudio's frames are the labels, as the product's own reader reads them") {
  const Exported exported(ExportTarget::nerfstudio);
  std::map<std::string, Seen> seen = seen_by(exported.root);
  for (const fs::path& condition : conditions_in(exported.out))
    for (const CalibratedCamera& camera : read_calibration(condition / "transforms.json")) {
      const Label& label = seen.at(camera.name.substr(std::string("images/").size())).label;
      CHECK(camera.distortion == label.distortion);
      CHECK(camera.pinhole.fx == label.camera.fx);
    }
}

TEST_CASE("the product's reader of KITTI's raw data finds each calibration with its images") {
  const Exported exported(ExportTarget::kitti);
  const Dataset dataset = read_dataset(exported.root);
  const std::vector<CameraPictures> cameras = kitti_raw(exported.out);
  REQUIRE(cameras.size() == dataset.groups.size());
  std::size_t pictures = 0;
  for (std::size_t g = 0; g < cameras.size(); ++g) {
    CHECK(cameras[g].camera.name == "02");
    CHECK(cameras[g].camera.distortion == dataset.groups[g].label.distortion);
    CHECK(cameras[g].camera.pinhole == dataset.groups[g].label.camera);
    pictures += cameras[g].files.size();
  }
  CHECK(pictures == dataset.images.size());
  for (const DatasetImage& image : dataset.images) {
    const std::string part = to_string(image.part), set = image.file.begin()->string(),
                      group = set + "_" + image.file.parent_path().filename().string();
    const fs::path data = exported.out / group / (group + "_drive_" + part + "_extract") / "image_02/data";
    CHECK(fs::equivalent(data / ("0000" + image.file.filename().string()), exported.root / image.file));
  }
}

TEST_CASE("COLMAP itself reads the models and writes the same numbers", "[slow]") {
  if (std::system("command -v colmap >/dev/null") != 0) {
    WARN("NOT TESTED: COLMAP's own reader: colmap is not installed");
    return;
  }
  const Exported exported(ExportTarget::colmap);
  for (const fs::path& condition : conditions_in(exported.out)) {
    const fs::path model = condition / "sparse/0", copy = exported.temporary.path / "copy";
    fs::create_directories(copy);
    REQUIRE(std::system(fmt::format("QT_QPA_PLATFORM=offscreen colmap model_converter --input_path {} "
                                    "--output_path {} --output_type TXT >/dev/null 2>&1",
                                    model.string(), copy.string())
                            .c_str()) == 0);
    const std::map<int, ColmapCamera> ours = colmap_cameras(model / "cameras.txt"),
                                      theirs = colmap_cameras(copy / "cameras.txt");
    REQUIRE(ours.size() == theirs.size());
    for (const auto& [id, camera] : ours) {
      CHECK(theirs.at(id).model == camera.model);
      CHECK(theirs.at(id).width == camera.width);
      for (std::size_t i = 0; i < camera.parameters.size(); ++i)
        CHECK(theirs.at(id).parameters.at(i) == Approx(camera.parameters[i]).epsilon(1e-12).margin(1e-15));
    }
    const auto images_in = [](const fs::path& file) {
      std::map<std::string, std::vector<double>> images;
      std::istringstream text(read_file(file));
      for (std::string line, points; std::getline(text, line);) {
        if (line.starts_with('#')) continue;
        std::getline(text, points);
        std::istringstream words(line);
        std::vector<double> numbers(9);  // id, pose, camera
        for (double& number : numbers) words >> number;
        std::string name;
        words >> name;
        images[name] = numbers;
      }
      return images;
    };
    const auto our_images = images_in(model / "images.txt"), their_images = images_in(copy / "images.txt");
    REQUIRE(our_images.size() == their_images.size());
    for (const auto& [name, numbers] : our_images)
      for (std::size_t i = 0; i < numbers.size(); ++i)
        CHECK(their_images.at(name)[i] == Approx(numbers[i]).epsilon(1e-9).margin(1e-12));
  }
}
