#include <map>
#include <numbers>
#include <sstream>

#include "dataset/exchange/model_calibration.h"
#include "distortion/models/projection.h"
#include "distortion/panorama/equirectangular.h"
#include "files/files.h"
#include "numbers/angles.h"
#include "tests/apps/pictures/pictures.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

constexpr int panorama_width = 1024;
constexpr double spot_deg = 1;  ///< standard deviation

/// The direction of a channel's bright spot: right, ahead-left, behind.
Eigen::Vector3d spot(int channel) {
  const double yaw = radians(60 + 120 * channel), elevation = radians(8 - 7 * channel);
  return {std::cos(elevation) * std::sin(yaw), -std::sin(elevation), std::cos(elevation) * std::cos(yaw)};
}

/// Light of a panorama that is dark but for a spot in each channel.
double light(int x, int y, int channel) {
  const Eigen::Vector3d d = direction({panorama_width, panorama_width / 2}, {double(x), double(y)});
  const double angle_deg = degrees(std::acos(std::clamp(d.dot(spot(channel)), -1.0, 1.0)));
  return std::exp(-0.5 * angle_deg * angle_deg / (spot_deg * spot_deg));
}

void write_spots(const fs::path& file) {
  write_image(file, panorama_width, panorama_width / 2, 3, OIIO::TypeUInt16, [](int x, int y, int c) {
    const double value = light(x, y, c);
    return value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
  });
}

/// The files of a split list.
std::vector<std::string> listed(const fs::path& set, const std::string& part) {
  std::vector<std::string> files;
  std::istringstream lines(read_file(set / "splits" / (part + ".txt")));
  for (std::string line; std::getline(lines, line);) files.push_back(line);
  return files;
}

std::map<std::string, std::string> parts_of_files(const fs::path& set) {
  std::map<std::string, std::string> parts;
  for (const char* part : {"train", "val", "test"})
    for (const std::string& file : listed(set, part)) parts[file] = part;
  return parts;
}

/// The direction in the camera's frame, by the label's pose. Panorama: x right, y down, z ahead; vehicle:
/// x ahead, y left, z up.
Eigen::Vector3d in_camera(const nlohmann::json& label, const Eigen::Vector3d& in_panorama) {
  const Eigen::Vector3d in_vehicle(in_panorama.z(), -in_panorama.x(), -in_panorama.y());
  Eigen::Matrix3d vehicle_from_camera;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column)
      vehicle_from_camera(row, column) = label["camera"]["T_vehicle_camera"][row][column];
  return vehicle_from_camera.transpose() * in_vehicle;
}

/// The centre of the light of one channel.
Eigen::Vector2d centre_of(const OIIO::ImageBuf& image, int channel) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double weight = 0;
  for (int y = 0; y < image.spec().height; ++y)
    for (int x = 0; x < image.spec().width; ++x) {
      const double value = linear(image.getchannel(x, y, 0, channel));
      if (value < 0.01) continue;
      sum += value * Eigen::Vector2d(x, y);
      weight += value;
    }
  return sum / weight;
}

/// Checks that the spots of an image lie where its label says. Returns how many it shows.
int check_spots(const fs::path& image_file) {
  const fs::path label_file = image_file.parent_path() / "calibration.json";
  const nlohmann::json label = read_json(label_file);
  const ModelCamera camera = read_model_camera(label_file, "");
  const OIIO::ImageBuf image = read_image(image_file);
  int seen = 0;
  for (int channel = 0; channel < 3; ++channel) {
    const Eigen::Vector3d d = in_camera(label, spot(channel));
    if (std::acos(d.z()) > radians(80)) continue;
    const Eigen::Vector2d expected = to_pixel(camera.pinhole, project(camera.lens, d).point);
    const double margin = 6;  // of a whole spot
    if (!(expected.x() > margin && expected.x() < camera.pinhole.width - margin && expected.y() > margin &&
          expected.y() < camera.pinhole.height - margin))
      continue;
    ++seen;
    INFO(image_file << ", channel " << channel);
    // A lens draws a spot out a little on one side.
    CHECK((centre_of(image, channel) - expected).norm() < 0.25);
  }
  return seen;
}

}  // namespace

TEST_CASE("views of a panorama show each direction at the pixel that their label says") {
  const TemporaryFolder folder;
  const fs::path in = folder.path / "panoramas";
  write_spots(in / "spots.png");
  for (const std::string family : {"brown_conrady", "kannala_brandt", "double_sphere"}) {
    const fs::path out = folder.path / family;
    run_well("relens --panorama " + in.string() + " -o " + out.string() + " --lens_model " + family +
             " --views 10 --hfov 90..110 --size 96x72 --seed 3 --pitch=-12..12");
    const auto parts = parts_of_files(out);
    REQUIRE(parts.size() == 10);
    int seen = 0;
    for (const auto& [file, part] : parts) seen += check_spots(out / file);
    CHECK(seen >= 3);
    const bool is_cps = family == "brown_conrady";
    CHECK(fs::exists(out / "dataset.json") != is_cps);
    if (!is_cps) CHECK(read_json(out / "dataset.json")["model"].get<std::string>() == family);
    const ProgramRun verified = run_cps("verify " + out.string());
    INFO(verified.output);
    CHECK(verified.exit_status == 0);
    CHECK_THAT(verified.output, Catch::Contains("10 groups, 10 images, 0 faults"));
    if (!is_cps) check_refused("report " + out.string(), 1, family);
  }
}

TEST_CASE("panoramas that are added leave parts and images of the others as they are") {
  const TemporaryFolder folder;
  const fs::path in = folder.path / "panoramas";
  const auto make = [&](const std::string& out) {
    run_well("relens --panorama " + in.string() + " -o " + (folder.path / out).string() +
             " --views 2 --size 48x32 --hfov 80..100");
  };
  write_spots(in / "b.png");
  fs::copy_file(in / "b.png", in / "d.png");
  make("few");
  for (const char* name : {"a.png", "c.png", "e.png"}) fs::copy_file(in / "b.png", in / name);
  make("more");
  const auto few = parts_of_files(folder.path / "few"), more = parts_of_files(folder.path / "more");
  CHECK(few.size() == 4);
  CHECK(more.size() == 10);
  for (const auto& [file, part] : few) {
    CHECK(more.at(file) == part);
    CHECK(read_file(folder.path / "few" / file) == read_file(folder.path / "more" / file));
  }
  // All views of a panorama are in one part.
  for (const auto& [file, part] : more)
    CHECK(more.at(file.substr(0, file.find("_lens")) + "_lens0001/000000.png") == part);
}

TEST_CASE("a panorama of linear light is exposed as a render is") {
  const TemporaryFolder folder;
  const fs::path in = folder.path / "panoramas", out = folder.path / "set";
  write_image(in / "gray.exr", panorama_width, panorama_width / 2, 3, OIIO::TypeFloat,
              [](int, int, int) { return 40; });
  run_well("relens --panorama " + in.string() + " -o " + out.string() + " --views 2 --size 48x32");
  for (const auto& [file, part] : parts_of_files(out)) {
    const OIIO::ImageBuf image = read_image(out / file);
    CHECK(image.spec().format == OIIO::TypeUInt8);
    double mean = 0, square = 0;
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 48; ++x) {
        const double value = linear(image.getchannel(x, y, 0, 1));
        mean += value / (48 * 32);
        square += value * value / (48 * 32);
      }
    // Metered to 18 % of white, with a drawn bias of at most half a stop.
    CHECK(mean > 0.18 / std::sqrt(2.0) * 0.97);
    CHECK(mean < 0.18 * std::sqrt(2.0) * 1.03);
    CHECK(square - mean * mean > 0);  // a sensor's noise
  }
}

TEST_CASE("panoramas that relens cannot use are refused in one line") {
  const TemporaryFolder folder;
  const fs::path in = folder.path / "panoramas";
  const std::string run = "relens -o " + (folder.path / "set").string() + " --panorama " + in.string();
  check_refused(run, 1, "is not a folder of panoramas");
  fs::create_directories(in);
  check_refused(run, 1, "has no pictures");
  write_image(in / "a.png", 300, 128, 1, OIIO::TypeUInt8, noise);
  check_refused(run, 1, "a.png: is 300 x 128 pixels");
  write_image(in / "a.png", 256, 128, 1, OIIO::TypeUInt8, noise);
  check_refused(run + " --size 640x480", 1, "256 pixels around");
  for (const char* name : {"a.png", "a.tif"}) write_image(in / name, 1024, 512, 1, OIIO::TypeUInt8, noise);
  check_refused(run + " --size 48x32", 1, "a.tif: has the name of a.png");
  check_refused(run + " --lens_model rational", 2, "--lens_model: must be one of");
  check_refused(run + " --hfov 60..170", 2, "--hfov: must lie in");
  check_refused(run + " --hfov 60-90", 2, "--hfov 60-90");
  check_refused(run + " --lenses 4", 2, "--lenses: does not go with --panorama");
  check_refused(run + " --lens_model eucm --lens_draw sequential", 2, "--lens_draw: draws brown_conrady");
  check_refused("relens -o x --kitti y --views 4", 2, "--views: needs --panorama");
  CHECK_FALSE(fs::exists(folder.path / "set"));
}
