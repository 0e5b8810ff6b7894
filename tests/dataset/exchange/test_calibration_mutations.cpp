#include <cmath>

#include "distortion/certificate/frame_certificate.h"
#include "random/counter_hash.h"
#include "tests/dataset/exchange/read_text.h"

using namespace cps;

namespace {

struct Sample {
  std::string name, text;
  /// The text that names the lens model of another family than brown_conrady and rational, and that family.
  std::string naming = {};
  std::string family = {};
};

/// What a format's file of a family says it with.
std::string naming_text(CalibrationFormat format, const LensModel& lens) {
  const std::string family(family_name(lens));
  if (family == "brown_conrady" || family == "rational") return "";
  const bool is_fisheye = family == "kannala_brandt";
  switch (format) {
    case CalibrationFormat::cps:
      return "\"model\": \"" + family + "\"";
    case CalibrationFormat::opencv_yaml:
      return is_fisheye ? "fisheye_model: 1\n" : "camera_model: omnidir\n";
    case CalibrationFormat::opencv_xml:
      return is_fisheye ? "<fisheye_model>1</fisheye_model>" : "<camera_model>omnidir</camera_model>";
    case CalibrationFormat::colmap:
      return is_fisheye ? "00 OPENCV_FISHEYE " : "00 EUCM ";
    case CalibrationFormat::ros:
      return "distortion_model: equidistant\n";
    case CalibrationFormat::kalibr:
      if (is_fisheye) return "distortion_model: equidistant\n";
      if (family == "eucm") return "camera_model: eucm\n";
      return family == "double_sphere" ? "camera_model: ds\n" : "camera_model: omni\n";
    default:
      return "\"camera_model\": \"OPENCV_FISHEYE\"";
  }
}

/// A file of every format and family that is written, and of some that are only read.
std::vector<Sample> samples() {
  const LensModel lenses[] = {
      Distortion{.k1 = -0.3, .k2 = 0.1, .p1 = 0.001, .p2 = -0.002},
      RationalLens{
          .k1 = 0.4, .k2 = -0.07, .k3 = 0.02, .k4 = 0.5, .k5 = 0.06, .k6 = 0.002, .p1 = 0.003, .p2 = -0.001},
      KannalaBrandt{.k1 = -0.02, .k2 = 0.01, .k3 = 0.003, .k4 = -0.001},
      UnifiedSpherical{.xi = 1.25, .distortion = {.k1 = -0.2, .k2 = 0.1, .p1 = 0.003, .p2 = -0.001}},
      Eucm{.alpha = 0.6, .beta = 1.1},
      DoubleSphere{.xi = -0.2, .alpha = 0.55}};
  std::vector<Sample> result;
  for (const LensModel& lens : lenses)
    for (const CalibrationFormat format :
         {CalibrationFormat::cps, CalibrationFormat::opencv_yaml, CalibrationFormat::opencv_xml,
          CalibrationFormat::colmap, CalibrationFormat::ros, CalibrationFormat::kitti,
          CalibrationFormat::kalibr, CalibrationFormat::nerfstudio}) {
      if (!can_hold(format, lens)) continue;
      const ModelCamera camera{"00", {640, 480, 500, 501, 318.25, 241.75}, lens};
      const std::string name = usual_file_name(format), naming = naming_text(format, lens);
      const std::filesystem::path file = file_of(name, "");
      write_model_calibration(file, format, std::vector{camera});
      result.push_back({name, read_file(file), naming, std::string(family_name(lens))});
      REQUIRE(result.back().text.find(naming) != std::string::npos);
    }
  result.push_back({"orb.yaml",
                    "%YAML:1.0\nCamera.type: PinHole\nCamera.width: 640\nCamera.height: 480\nCamera.fx: 500\n"
                    "Camera.fy: 501\nCamera.cx: 318\nCamera.cy: 241\nCamera.k1: -0.3\n"});
  result.push_back(
      {"vins.yaml",
       "model_type: PINHOLE\nimage_width: 640\nimage_height: 480\nprojection_parameters:\n  fx: 500\n"
       "  fy: 501\n  cx: 318\n  cy: 241\ndistortion_parameters: {k1: -0.3, k2: 0.1}\n"});
  result.push_back({"mei.yaml",
                    "model_type: MEI\nimage_width: 640\nimage_height: 480\nmirror_parameters: {xi: 1.25}\n"
                    "distortion_parameters: {k1: -0.2, k2: 0.1, p1: 0.003, p2: -0.001}\n"
                    "projection_parameters: {gamma1: 500, gamma2: 501, u0: 318, v0: 241}\n",
                    "model_type: MEI\n", "unified_spherical"});
  result.push_back(
      {"metashape.xml",
       "<calibration><projection>frame</projection><width>640</width><height>480</height><f>500</f>"
       "<cx>7</cx><k1>-0.3</k1></calibration>"});
  return result;
}

/// The text with a few bytes, lines or numbers changed.
std::string mutated(std::string text, Stream stream) {
  static constexpr const char* pieces[] = {"nan",
                                           "inf",
                                           "-1",
                                           "1e999",
                                           "1e308",
                                           "0",
                                           "99999999999999999999",
                                           "0,5",
                                           "\"",
                                           "{",
                                           "]",
                                           "&a [*a, *a]",
                                           "\n",
                                           "---",
                                           ":",
                                           "\xff",
                                           "<",
                                           "k4: 1\n",
                                           "model: fisheye\n",
                                           "xi: 1.5\n",
                                           "\"is_fisheye\": true, ",
                                           "\xEF\xBB\xBF"};
  std::uint64_t index = 0;
  const auto below = [&](std::uint64_t count) { return random_below(stream, index++, count); };
  for (std::uint64_t left = 1 + below(3); left > 0 && !text.empty(); --left) {
    const std::size_t at = below(text.size());
    const std::size_t digit = text.find_first_of("0123456789", at);
    switch (below(5)) {
      case 0:
        text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.erase(at, 1 + below(20));
        break;
      case 2:
        text.insert(at, pieces[below(std::size(pieces))]);
        break;
      case 3:
        text.insert(at, text.substr(below(text.size()), 1 + below(60)));
        break;
      default:
        if (digit == std::string::npos) break;
        text.replace(digit, text.find_first_not_of("0123456789.-+e", digit) - digit,
                     pieces[below(std::size(pieces))]);
    }
  }
  return text;
}

void read_mutations(std::uint64_t seed, int count) {
  const std::vector<Sample> originals = samples();
  const Stream stream = make_stream(seed, "calibration mutations");
  int read = 0;
  for (int i = 0; i < count; ++i) {
    const Sample& sample = originals[i % originals.size()];
    const std::string text = mutated(sample.text, substream(stream, i));
    const std::filesystem::path file = file_of(sample.name, text);
    INFO(text);
    const bool still_names_lens = !sample.naming.empty() && text.find(sample.naming) != std::string::npos;
    try {
      for (const ModelCamera& camera : read_model_calibration_file(file).cameras) {
        const auto& [width, height, fx, fy, cx, cy] = camera.pinhole;
        for (double value : {fx, fy, cx, cy}) REQUIRE(std::isfinite(value));
        REQUIRE(fault(camera.lens).empty());
        // No fisheye file is read as anything else.
        if (still_names_lens) REQUIRE(family_name(camera.lens) == sample.family);
        if (const auto* lens = std::get_if<Distortion>(&camera.lens)) {
          const FrameCertificate proof = certify_frame(*lens, camera.pinhole);
          if (proof.certificate.valid) REQUIRE(std::isfinite(proof.certificate.min_eigenvalue));
        }
        ++read;
      }
    } catch (const std::runtime_error& error) {
      const std::string what = error.what();
      REQUIRE_THAT(what, Catch::StartsWith(file.string() + ": "));
      REQUIRE(what.find('\n') == std::string::npos);
    }
  }
  CHECK(read > count / 20);  // many changes do no harm
  CHECK(read < count);
}

}  // namespace

TEST_CASE("mutated calibrations are read as finite cameras or refused in one line") {
  read_mutations(1, 3000);
}

TEST_CASE("a minute of mutated calibrations", "[slow]") {
  read_mutations(2, 30'000);
}
