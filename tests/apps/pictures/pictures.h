#pragma once

#include <OpenImageIO/imagebuf.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "dataset/exchange/calibration_file.h"
#include "random/counter_hash.h"
#include "tests/apps/cps_program.h"

/// Pictures for `cps distort` and `cps undistort` to work on, and a lens.
namespace cps {

namespace fs = std::filesystem;

/// A picture from a function of column, row and channel; integers as fractions of their largest value.
inline void write_image(const fs::path& file, int width, int height, int channels, OIIO::TypeDesc type,
                        const std::function<double(int x, int y, int channel)>& value) {
  fs::create_directories(file.parent_path());
  OIIO::ImageSpec spec(width, height, channels, type);
  if (channels == 2) spec.channelnames = {"Y", "A"}, spec.alpha_channel = 1;
  if (channels == 4) spec.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::ImageBuf image(spec);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) {
        std::vector<float> pixel(channels);
        image.getpixel(x, y, pixel.data());
        pixel[c] = float(value(x, y, c));
        image.setpixel(x, y, pixel.data());
      }
  REQUIRE(image.write(file.string(), type));
}

inline OIIO::ImageBuf read_image(const fs::path& file) {
  OIIO::ImageSpec keep_alpha;
  keep_alpha.attribute("oiio:UnassociatedAlpha", 1);
  OIIO::ImageBuf image(file.string(), 0, 0, nullptr, &keep_alpha);
  INFO(file);
  REQUIRE(image.read(0, 0, true));
  return image;
}

inline double linear(double srgb) {
  return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4);
}

inline double noise(int x, int y, int c) {
  return random_uniform(make_stream(51, "noise"), (std::uint64_t(y) * 1000 + x) * 4 + c);
}

inline const CalibratedCamera barrel{
    "cam", {160, 100, 100, 101, 82, 47}, {.k1 = -0.18, .k2 = 0.03, .p1 = 0.002, .p2 = -0.003}};

inline fs::path write_barrel(const fs::path& folder) {
  write_calibration(folder / "barrel.yml", CalibrationFormat::opencv_yaml, std::vector{barrel});
  return folder / "barrel.yml";
}

inline void run_well(const std::string& arguments) {
  const ProgramRun run = run_cps(arguments);
  INFO("cps " << arguments << "\n" << run.output);
  REQUIRE(run.exit_status == 0);
}

inline CalibratedCamera label(const fs::path& file) {
  return read_calibration(file).front();
}

}  // namespace cps
