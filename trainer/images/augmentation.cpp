#include "trainer/images/augmentation.h"

#include <cmath>
#include <numbers>

#include "trainer/images/corruptions.h"

namespace cps {
namespace {

double log_uniform(Stream stream, std::uint64_t index, double max) {
  return std::exp(random_uniform(stream, index, -std::log(max), std::log(max)));
}

}  // namespace

std::string Augmentation::fault() const {
  if (!(probability >= 0 && probability <= 1)) return "augment: must lie in [0, 1]";
  if (!(max_blur_sigma_px >= 0 && max_blur_sigma_px <= 20)) return "max_blur_sigma_px: must lie in [0, 20]";
  if (!(max_motion_blur_px >= 0 && max_motion_blur_px <= 100))
    return "max_motion_blur_px: must lie in [0, 100]";
  if (!(max_gamma >= 1 && max_gamma <= 10)) return "max_gamma: must lie in [1, 10]";
  if (!(max_iso_noise >= 0 && max_iso_noise <= 255)) return "max_iso_noise: must lie in [0, 255]";
  if (min_jpeg_quality < 1 || min_jpeg_quality > 100) return "min_jpeg_quality: must lie in [1, 100]";
  if (!(max_brightness >= 0 && max_brightness <= 255)) return "max_brightness: must lie in [0, 255]";
  if (!(max_contrast >= 1 && max_contrast <= 10)) return "max_contrast: must lie in [1, 10]";
  if (!(max_cutout >= 0 && max_cutout <= 1)) return "max_cutout: must lie in [0, 1]";
  return "";
}

GrayImage augmented(const GrayView& view, const Augmentation& o, Stream stream) {
  GrayImage image{view.size, {view.pixels, view.pixels + pixel_count(view.size)}};
  const Stream chances = make_stream(stream.key, "chances"), strengths = make_stream(stream.key, "strengths");
  std::uint64_t change = 0;
  const auto is_drawn = [&] { return random_uniform(chances, change++) < o.probability; };

  if (is_drawn()) cut_out(image, o.max_cutout, make_stream(stream.key, "cutout"));
  if (is_drawn()) apply_gamma(image, log_uniform(strengths, 0, o.max_gamma));
  if (is_drawn())
    apply_contrast(image, log_uniform(strengths, 1, o.max_contrast),
                   random_uniform(strengths, 2, -o.max_brightness, o.max_brightness));
  if (is_drawn()) blur(image, random_uniform(strengths, 3, 0, o.max_blur_sigma_px));
  if (is_drawn())
    motion_blur(image, random_uniform(strengths, 4, 1, std::max(1.0, o.max_motion_blur_px)),
                random_uniform(strengths, 5, 0, std::numbers::pi));
  if (is_drawn())
    add_iso_noise(image, random_uniform(strengths, 6, 0, o.max_iso_noise), make_stream(stream.key, "noise"));
  if (is_drawn())
    compress_as_jpeg(
        image, o.min_jpeg_quality + static_cast<int>(random_below(strengths, 7, 101 - o.min_jpeg_quality)));
  return image;
}

}  // namespace cps
