#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "distortion/warp/master_camera.h"
#include "files/files.h"
#include "numbers/angles.h"
#include "production/view_images.h"
#include "tests/temporary_folder.h"
#include "trainer/images/master_cache.h"
#include "trainer/training/online_images.h"

using namespace cps;

namespace {

const Pinhole base = pinhole_from_hfov(174, 64, radians(80.0));
const double min_eigenvalue = LensBounds{}.min_eigenvalue;

/// Two renders of coloured stripes and slopes, each with noise of its own. Where `fits_halves`, mean and
/// difference are multiples of 1/256 below 4, which half floats hold exactly.
RenderedView stripes(const Pinhole& camera, bool fits_halves) {
  const OIIO::ImageSpec spec(camera.width, camera.height, 3, OIIO::TypeDesc::FLOAT);
  RenderedView halves{.first = OIIO::ImageBuf(spec), .second = OIIO::ImageBuf(spec)};
  auto* first = static_cast<float*>(halves.first.localpixels());
  auto* second = static_cast<float*>(halves.second.localpixels());
  const Stream noise = make_stream(3, "stripes");
  for (int y = 0; y < camera.height; ++y)
    for (int x = 0; x < camera.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const std::size_t i = (static_cast<std::size_t>(y) * camera.width + x) * 3 + c;
        double light = 0.1 + (x / (7 + 4 * c) % 2) * 0.5 + (0.1 + 0.05 * c) * std::sin(0.05 * y + c);
        double difference = 0.02 * random_normal(noise, i);
        light = std::max(light, 0.0);
        if (fits_halves) {
          light = std::round(256 * light) / 256;
          difference = std::round(256 * difference) / 256;
        }
        first[i] = static_cast<float>(light + difference);
        second[i] = static_cast<float>(light - difference);
      }
  return halves;
}

/// A dataset of one view with a kept master, made by the product, and the same images made online.
struct OneView {
  TemporaryFolder folder;
  ViewImages wanted;
  MasterCache cache;

  OneView(ImageFormat format, bool fits_halves) {
    wanted.master = master_camera(base, {}, min_eigenvalue);
    wanted.master_file = "masters/front_0.exr";
    wanted.format = format;
    wanted.jpeg_quality = 70;
    LensOptions lenses;
    lenses.scheme = LensScheme::shape_prior;
    for (std::uint64_t i = 0; i < 3; ++i) {
      const DrawnLens lens =
          i == 0 ? undistorted_lens(base) : draw_lens(base, CropOrder::base_first, lenses, Stream{i});
      wanted.images.push_back({.file = fmt::format("lens{}.{}", i, extension_of(format)),
                               .lens = cropped(lens),
                               .sensor = make_stream(i, "sensor")});
    }
    ImageTimes times;
    const ViewRecord record =
        make_images(wanted, stripes(wanted.master, fits_halves), folder.path, times).record;
    const Pinhole& camera = wanted.master;
    write_file(folder.path / "masters.csv",
               fmt::format("file,part,width,height,fx,fy,cx,cy,image_width,image_height,base_hfov_deg,"
                           "set_hfov_deg,exposure,sha256\n{},train,{},{},{},{},{},{},{},{},80,80,{},{}\n",
                           record.master->file, camera.width, camera.height, camera.fx, camera.fy, camera.cx,
                           camera.cy, base.width, base.height, record.exposure, record.master->sha256));
    cache = load_master_cache(folder.path, Part::train, format == ImageFormat::png_gray, false, {});
  }

  /// Share of the stored images' gray pixels from which the online images differ, and by how much at most.
  struct Difference {
    double share = 0;
    int max_levels = 0;
  };
  Difference difference() const {
    Difference found;
    for (const PlannedImage& image : wanted.images) {
      const GrayImage stored = read_gray_image(folder.path / image.file);
      const GrayImage online =
          online_image(cache.master(0), image.lens, sensor_of(wanted.sensor, image.sensor),
                       {wanted.format, wanted.jpeg_quality});
      REQUIRE(online.size == stored.size);
      for (std::size_t p = 0; p < stored.pixels.size(); ++p) {
        const int levels = std::abs(int(stored.pixels[p]) - int(online.pixels[p]));
        found.max_levels = std::max(found.max_levels, levels);
        found.share += (levels != 0) / (3.0 * static_cast<double>(stored.pixels.size()));
      }
    }
    return found;
  }
};

}  // namespace

TEST_CASE("an online image is the stored file of the same lens and noise") {
  const ImageFormat format = GENERATE(ImageFormat::png, ImageFormat::jpeg, ImageFormat::exr);
  CAPTURE(to_string(format));
  const OneView view(format, true);
  CHECK(view.cache.channels == 3);
  CHECK(view.difference().share == 0);
}

// Kept masters are half floats, with a relative error up to 2^-12, and png_gray's are rounded after the
// luminance: a code near its threshold may move by one. Of an 8-bit code c, about c/2.2 · 2^-12, 1 or 2 % of
// the pixels at most; JPEG spreads such a step over its block.
TEST_CASE("an online image of a master that half floats round is the stored file but for single levels") {
  const ImageFormat format = GENERATE(ImageFormat::png, ImageFormat::png_gray);
  CAPTURE(to_string(format));
  const OneView view(format, false);
  CHECK(view.cache.channels == (format == ImageFormat::png_gray ? 1 : 3));
  const OneView::Difference difference = view.difference();
  CAPTURE(difference.share);
  CHECK(difference.max_levels <= 1);
  CHECK(difference.share < 0.02);
}
