#include <cmath>

#include "distortion/certificate/frame_certificate.h"
#include "random/counter_hash.h"
#include "tests/dataset/exchange/read_text.h"

using namespace cps;

namespace {

struct Sample {
  std::string name, text;
};

/// A file of every format that is written, and of some that are only read.
std::vector<Sample> samples() {
  const CalibratedCamera camera{
      "00", {640, 480, 500, 501, 318.25, 241.75}, {.k1 = -0.3, .k2 = 0.1, .p1 = 0.001, .p2 = -0.002}};
  std::vector<Sample> result;
  for (const CalibrationFormat format :
       {CalibrationFormat::cps, CalibrationFormat::opencv_yaml, CalibrationFormat::opencv_xml,
        CalibrationFormat::colmap, CalibrationFormat::ros, CalibrationFormat::kitti,
        CalibrationFormat::kalibr, CalibrationFormat::nerfstudio}) {
    const std::string name = usual_file_name(format);
    const std::filesystem::path file = file_of(name, "");
    write_calibration(file, format, std::vector{camera});
    result.push_back({name, read_file(file)});
  }
  result.push_back({"orb.yaml",
                    "%YAML:1.0\nCamera.type: PinHole\nCamera.width: 640\nCamera.height: 480\nCamera.fx: 500\n"
                    "Camera.fy: 501\nCamera.cx: 318\nCamera.cy: 241\nCamera.k1: -0.3\n"});
  result.push_back(
      {"vins.yaml",
       "model_type: PINHOLE\nimage_width: 640\nimage_height: 480\nprojection_parameters:\n  fx: 500\n"
       "  fy: 501\n  cx: 318\n  cy: 241\ndistortion_parameters: {k1: -0.3, k2: 0.1}\n"});
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
    try {
      for (const CalibratedCamera& camera : read_calibration(file)) {
        const auto& [width, height, fx, fy, cx, cy] = camera.pinhole;
        const Distortion& lens = camera.distortion;
        for (double value : {fx, fy, cx, cy, lens.k1, lens.k2, lens.k3, lens.p1, lens.p2})
          REQUIRE(std::isfinite(value));
        const FrameCertificate proof = certify_frame(lens, camera.pinhole);
        if (proof.certificate.valid) REQUIRE(std::isfinite(proof.certificate.min_eigenvalue));
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
