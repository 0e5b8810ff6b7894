#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "tests/dataset/exchange/read_text.h"

using namespace cps;

namespace {

// All numbers differ and none is short: any exchange, any half pixel, any rounding shows.
const Pinhole round_trip_pinhole{1392, 512, 384.2439123456789, 980.8141 / 3, 690.1234, 233.1966};

const std::vector<LensModel> lenses{
    Distortion{.k1 = -0.31 / 3, .k2 = 0.11 / 7, .p1 = 0.0013 / 3, .p2 = -0.0021 / 7},
    RationalLens{.k1 = 0.41 / 3,
                 .k2 = -0.07 / 3,
                 .k3 = 0.003 / 7,
                 .k4 = 0.52 / 3,
                 .k5 = 0.06 / 7,
                 .k6 = 0.002 / 3,
                 .p1 = 0.0013 / 3,
                 .p2 = -0.0021 / 7},
    KannalaBrandt{.k1 = -0.02 / 3, .k2 = 0.01 / 7, .k3 = 0.003 / 7, .k4 = -0.001 / 3},
    UnifiedSpherical{.xi = 3.7 / 3,
                     .distortion = {.k1 = -0.2 / 3, .k2 = 0.1 / 7, .p1 = 0.003 / 7, .p2 = -0.001 / 3}},
    Eucm{.alpha = 1.9 / 3, .beta = 3.3 / 3},
    DoubleSphere{.xi = -0.5 / 3, .alpha = 1.7 / 3}};

constexpr std::array formats{CalibrationFormat::cps,        CalibrationFormat::opencv_yaml,
                             CalibrationFormat::opencv_xml, CalibrationFormat::colmap,
                             CalibrationFormat::ros,        CalibrationFormat::kitti,
                             CalibrationFormat::kalibr,     CalibrationFormat::nerfstudio};

bool moves_half_pixels(CalibrationFormat format) {
  return format == CalibrationFormat::colmap || format == CalibrationFormat::nerfstudio;
}

std::filesystem::path no_file(CalibrationFormat format) {
  const std::filesystem::path file = file_of(usual_file_name(format), "");
  std::filesystem::remove(file);
  return file;
}

std::string family(const LensModel& lens) {
  return std::string(family_name(lens));
}

}  // namespace

TEST_CASE("every format reads back every lens that it can hold, and refuses the others") {
  int held = 0;
  for (const CalibrationFormat format : formats)
    for (const LensModel& lens : lenses) {
      INFO(to_string(format) << " " << family(lens));
      const ModelCamera written{"02", round_trip_pinhole, lens};
      const std::filesystem::path file = no_file(format);
      if (!can_hold(format, lens)) {
        const std::string why =
            refusal_of(file, [&] { write_model_calibration(file, format, std::vector{written}); });
        CHECK_THAT(why, Catch::Contains(family(lens) + ", which " + to_string(format) + " cannot say") &&
                            Catch::Contains("write it as cps"));
        CHECK_FALSE(std::filesystem::exists(file));
        continue;
      }
      ++held;
      write_model_calibration(file, format, std::vector{written});
      const ModelCamera read = read_model_camera(file, "");
      CHECK(read.lens == lens);
      Pinhole expected = round_trip_pinhole;
      if (moves_half_pixels(format)) {
        constexpr double last_bit = std::numeric_limits<double>::epsilon();
        CHECK(std::abs(read.pinhole.cx - round_trip_pinhole.cx) <= last_bit * round_trip_pinhole.cx);
        CHECK(std::abs(read.pinhole.cy - round_trip_pinhole.cy) <= last_bit * round_trip_pinhole.cy);
        expected.cx = read.pinhole.cx;
        expected.cy = read.pinhole.cy;
      }
      CHECK(read.pinhole == expected);
    }
  // 6 cps, 4 + 4 OpenCV, 4 COLMAP, 3 ROS, 1 KITTI, 5 Kalibr, 2 nerfstudio.
  CHECK(held == 29);
}

TEST_CASE("k3 is held where the format has a place for it") {
  const LensModel plane = Distortion{.k1 = -0.3, .k3 = 0.05};
  const LensModel sphere = UnifiedSpherical{.xi = 1.1, .distortion = {.k1 = -0.2, .k3 = 0.05}};
  CHECK(can_hold(CalibrationFormat::opencv_yaml, plane));
  CHECK_FALSE(can_hold(CalibrationFormat::kalibr, plane));
  CHECK_FALSE(can_hold(CalibrationFormat::kalibr, sphere));
  CHECK_FALSE(can_hold(CalibrationFormat::opencv_yaml, sphere));
  const std::filesystem::path file = no_file(CalibrationFormat::kalibr);
  CHECK_THAT(refusal_of(file,
                        [&] {
                          write_model_calibration(
                              file, CalibrationFormat::kalibr,
                              std::vector{ModelCamera{"left", round_trip_pinhole, sphere}});
                        }),
             Catch::Contains("left: k3 is not 0, which kalibr has no place for: write it as cps"));
  const std::filesystem::path json = no_file(CalibrationFormat::cps);
  write_model_calibration(json, CalibrationFormat::cps,
                          std::vector{ModelCamera{"left", round_trip_pinhole, sphere}});
  CHECK(read_model_camera(json, "left").lens == sphere);
}

TEST_CASE("Brown–Conrady gives the same bytes as a camera of any family") {
  const CalibratedCamera camera{"02", round_trip_pinhole, std::get<Distortion>(lenses[0])};
  for (const CalibrationFormat format : formats) {
    INFO(to_string(format));
    const std::filesystem::path file = no_file(format);
    write_calibration(file, format, std::vector{camera});
    const std::string bytes = read_file(file);
    write_model_calibration(file, format, std::vector{model_camera(camera)});
    CHECK(read_file(file) == bytes);
  }
}

TEST_CASE("readers of Brown–Conrady refuse other families by name and keep the rest of the file") {
  const std::filesystem::path file = file_of("cameras.txt", "");
  write_model_calibration(file, CalibrationFormat::colmap,
                          std::vector{ModelCamera{"1", round_trip_pinhole, lenses[0]},
                                      ModelCamera{"2", round_trip_pinhole, lenses[2]}});
  CHECK(read_camera(file, "1").distortion == std::get<Distortion>(lenses[0]));
  CHECK_THAT(refusal_of(file, [&] { read_camera(file, "2"); }),
             Catch::Contains("2: its lens model is kannala_brandt") && Catch::Contains("cps lens convert"));
  CHECK_THAT(refusal_of(file, [&] { read_calibration(file); }), Catch::Contains("kannala_brandt"));
  CHECK(read_model_calibration_file(file).cameras.size() == 2);
}

TEST_CASE("a file of several families: kalibr and colmap hold them, nerfstudio holds one") {
  const std::vector<ModelCamera> cameras{{"1", round_trip_pinhole, lenses[0]},
                                         {"2", round_trip_pinhole, lenses[2]}};
  const std::filesystem::path kalibr = no_file(CalibrationFormat::kalibr);
  write_model_calibration(kalibr, CalibrationFormat::kalibr, cameras);
  CHECK(read_model_camera(kalibr, "cam0").lens == lenses[0]);
  CHECK(read_model_camera(kalibr, "cam1").lens == lenses[2]);
  const std::filesystem::path json = no_file(CalibrationFormat::nerfstudio);
  CHECK_THAT(refusal_of(json, [&] { write_model_calibration(json, CalibrationFormat::nerfstudio, cameras); }),
             Catch::Contains("cameras of one lens model"));
}

TEST_CASE("calibration.json of another family has no key that a reader of CPS datasets could misread") {
  for (const LensModel& lens : lenses) {
    if (std::holds_alternative<Distortion>(lens)) continue;
    const std::filesystem::path file = no_file(CalibrationFormat::cps);
    write_model_calibration(file, CalibrationFormat::cps,
                            std::vector{ModelCamera{"02", round_trip_pinhole, lens}});
    const nlohmann::json json = nlohmann::json::parse(read_file(file));
    for (const char* key : {"fov", "k1", "k2", "k3", "p1", "p2", "cx", "cy"}) CHECK_FALSE(json.contains(key));
    CHECK(json.at("model") == family(lens));
    CHECK(json.at("params").size() == parameters(lens).size());
  }
}
