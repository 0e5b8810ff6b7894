#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>

#include "tests/apps/cps_program.h"
#include "tests/apps/street_gltf.h"
#include "tests/temporary_folder.h"

/// An independent reader, written from docs/formats.md without the product's code: plain files, JSON, and the
/// distortion formula.
namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

constexpr double degree = 3.14159265358979323846 / 180;

struct Point {
  double x, y;
};

Point distorted_pixel(const Json& label, Point p) {
  const double k1 = label.at("k1"), k2 = label.at("k2"), k3 = label.at("k3");
  const double p1 = label.at("p1"), p2 = label.at("p2");
  const double r2 = p.x * p.x + p.y * p.y;
  const double radial = 1 + k1 * r2 + k2 * r2 * r2 + k3 * r2 * r2 * r2;
  const double x = p.x * radial + 2 * p1 * p.x * p.y + p2 * (r2 + 2 * p.x * p.x);
  const double y = p.y * radial + p1 * (r2 + 2 * p.y * p.y) + 2 * p2 * p.x * p.y;
  const Json& k = label.at("K");
  return {double(k[0][0]) * x + double(k[0][2]), double(k[1][1]) * y + double(k[1][2])};
}

/// How far outside the image's frame a pixel lies; negative inside.
double outside_px(const Json& label, Point pixel) {
  const double w = label.at("width"), h = label.at("height");
  return std::max({-0.5 - pixel.x, pixel.x - (w - 0.5), -0.5 - pixel.y, pixel.y - (h - 0.5)});
}

/// Half width and half height of the undistorted render on the plane z = 1.
Point render_half(const Json& label) {
  const double x = std::tan(double(label.at("fov_base_deg")) * degree / 2);
  return {x, x * double(label.at("height")) / double(label.at("width"))};
}

/// Smallest distance by which the render's rim, seen through the lens, stays outside the frame (pixels).
double nearest_rim_px(const Json& label) {
  const Point half = render_half(label);
  double nearest = 1e30;
  for (int i = 0; i <= 2000; ++i)
    for (double side : {-1.0, 1.0}) {
      const double t = -1 + i / 1000.0;
      nearest = std::min(nearest, outside_px(label, distorted_pixel(label, {side * half.x, t * half.y})));
      nearest = std::min(nearest, outside_px(label, distorted_pixel(label, {t * half.x, side * half.y})));
    }
  return nearest;
}

/// The SHA-256 that frames.csv gives for each image, by the image's path.
std::map<std::string, std::string> frames_of(const fs::path& leaf) {
  std::ifstream in(leaf / "frames.csv");
  std::string line;
  std::getline(in, line);
  CHECK(line.starts_with("file,part,condition,street,"));
  std::map<std::string, std::string> frames;
  while (std::getline(in, line)) frames[line.substr(0, line.find(','))] = line.substr(line.rfind(',') + 1);
  return frames;
}

struct Found {
  int images = 0, leaves = 0;
};

/// Reads a whole dataset, whose folders are named after the label's key `named_after`, and checks it.
Found read_as_a_stranger(const fs::path& root, const char* named_after) {
  Found found;
  for (const auto& set : fs::directory_iterator(root)) {
    std::smatch named;
    const std::string set_name = set.path().filename().string();
    if (!std::regex_match(set_name, named, std::regex(R"((\d+)x(\d+)_hfov(\d{3}))"))) continue;
    for (const auto& leaf : fs::directory_iterator(set)) {
      INFO(leaf.path());
      ++found.leaves;
      CHECK(std::regex_match(leaf.path().filename().string(), std::regex(R"([a-z0-9]+_lens\d{4})")));
      const Json label = Json::parse(std::ifstream(leaf.path() / "calibration.json"));
      for (const char* key :
           {"fov",          "K",    "width",       "height",       "k1",     "k2",     "k3",
            "p1",           "p2",   "cx",          "cy",           "schema", "limits", "camera",
            "fov_base_deg", "crop", "certificate", "fov_true_deg", "part",   "seed",   "generator"})
        CHECK(label.contains(key));
      const double w = label.at("width"), fx = label.at("K")[0][0];
      CHECK(w == std::stod(named[1]));
      CHECK(double(label.at("height")) == std::stod(named[2]));
      CHECK(std::lround(double(label.at(named_after))) == std::stol(named[3]));
      CHECK(std::abs(2 * std::atan(w / (2 * fx)) / degree - double(label.at("fov"))) < 1e-6);
      CHECK(label.at("K")[0][0] == label.at("K")[1][1]);
      CHECK(label.at("K")[0][2] == label.at("cx"));
      CHECK(label.at("K")[1][2] == label.at("cy"));
      CHECK(nearest_rim_px(label) > -1e-6);

      const auto frames = frames_of(leaf.path());
      int pictures = 0;
      for (const auto& file : fs::directory_iterator(leaf)) {
        if (file.path().extension() != ".png") continue;
        ++pictures;
        REQUIRE(frames.contains(file.path().filename().string()));
        CHECK(frames.at(file.path().filename().string()).size() == 64);
        const auto in = OIIO::ImageInput::open(file.path().string());
        REQUIRE(in);
        CHECK(in->spec().width == label.at("width"));
        CHECK(in->spec().height == label.at("height"));
      }
      CHECK(pictures == static_cast<int>(frames.size()));
      found.images += pictures;
    }
  }
  int listed = 0;
  for (const char* part : {"train", "val", "test"}) {
    std::ifstream in(root / "splits" / (std::string(part) + ".txt"));
    for (std::string line; std::getline(in, line); ++listed) CHECK(fs::exists(root / line));
  }
  CHECK(listed == found.images);
  return found;
}

}  // namespace

TEST_CASE("a reader that knows only the documented format finds two levels, all keys, and true labels") {
  const cps::TemporaryFolder folder;
  const fs::path scene = cps::write_street_gltf(folder.path), root = folder.path / "dataset";
  const cps::ProgramRun made =
      cps::run_cps("generate --seed 8 --scene " + scene.string() +
                   " --size 96x54,110x40 --base_hfov_deg 40,90,140 --views 4 --lenses 3 --samples 2 --out " +
                   root.string());
  INFO(made.output);
  REQUIRE(made.exit_status == 0);

  const Found found = read_as_a_stranger(root, "fov_base_deg");
  CHECK(found.leaves >= 2 * 3 * (1 + 3));
  CHECK(found.images == 2 * 3 * 4 * (1 + 3));
}

TEST_CASE("every shipped recipe makes, at a tiny scale, what that reader reads", "[slow]") {
  struct Small {
    std::string name, sizes;
    const char* named_after;
    int images;
  };
  for (const Small& recipe :
       {Small{"cps-v1", "96x54", "fov_base_deg", 7 * 3}, Small{"cps-v2", "96x54", "fov_base_deg", 13 * 3 * 6},
        Small{"cps-v3", "96x54,110x40", "fov_base_deg", 13 * 3 * (6 + 11)},
        Small{"kitti", "110x40", "fov", 10 * 3 * 4 * 5},
        Small{"wide-aspects", "110x40,96x42,96x54,64x48,54x54,54x96", "fov", 48 * 3 * 5},
        Small{"smoke", "96x54", "fov_base_deg", 8 * 3 * 3}}) {
    INFO(recipe.name);
    const cps::TemporaryFolder folder;
    const fs::path root = folder.path / "dataset";
    const cps::ProgramRun made = cps::run_cps("generate --recipe " + recipe.name +
                                              " --scale 1e-6 --conditions_per_scene 1 --samples 2 --size " +
                                              recipe.sizes + " --out " + root.string());
    INFO(made.output);
    REQUIRE(made.exit_status == 0);
    CHECK(read_as_a_stranger(root, recipe.named_after).images == recipe.images);
  }
}
