#include "trainer/images/gray_image.h"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

namespace cps {
namespace {

/// The input pixels under one output pixel, along one axis.
struct Footprint {
  int first = 0;
  std::vector<float> weights;  ///< sum to 1
};

std::vector<Footprint> footprints(int from, int to) {
  const double scale = static_cast<double>(from) / to;
  std::vector<Footprint> result(to);
  for (int i = 0; i < to; ++i) {
    const double begin = i * scale, end = std::min<double>((i + 1) * scale, from);
    Footprint& footprint = result[i];
    footprint.first = std::min(static_cast<int>(begin), from - 1);
    for (int j = footprint.first; j < std::min(static_cast<int>(std::ceil(end)), from); ++j)
      footprint.weights.push_back(
          static_cast<float>((std::min<double>(end, j + 1) - std::max<double>(begin, j)) / (end - begin)));
  }
  return result;
}

[[noreturn]] void refuse_gray_image(const std::filesystem::path& file, std::string why) {
  std::ranges::replace(why, '\n', ' ');
  throw std::runtime_error(file.string() + ": cannot be read as an image (" + why +
                           "): restore the file or take it out of the list");
}

std::unique_ptr<OIIO::ImageInput> open_gray_image(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file)) refuse_gray_image(file, "no such file");
  OIIO::ImageSpec as_stored;  // colours not multiplied by alpha
  as_stored.attribute("oiio:UnassociatedAlpha", 1);
  std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(file.string(), &as_stored);
  if (!input) refuse_gray_image(file, OIIO::geterror());
  const OIIO::ImageSpec& spec = input->spec();
  if (spec.depth > 1 || spec.width < 8 || spec.height < 8)
    refuse_gray_image(file, "not a flat picture of at least 8x8 pixels");
  return input;
}

}  // namespace

ImageSize reduced_size(const ImageSize& original, const Reduction& reduction) {
  const double scale = reduction.factor > 0
                           ? 1.0 / reduction.factor
                           : std::min(1.0, static_cast<double>(reduction.width) / original.width);
  return {std::max(1, static_cast<int>(std::lround(original.width * scale))),
          std::max(1, static_cast<int>(std::lround(original.height * scale)))};
}

GrayImage area_average(const GrayImage& image, const ImageSize& to) {
  if (to == image.size) return image;
  const auto columns = footprints(image.size.width, to.width),
             rows = footprints(image.size.height, to.height);
  std::vector<float> narrow(static_cast<std::size_t>(to.width) * image.size.height);
  for (int y = 0; y < image.size.height; ++y) {
    const std::uint8_t* in = &image.pixels[static_cast<std::size_t>(y) * image.size.width];
    for (int x = 0; x < to.width; ++x) {
      float sum = 0;
      for (std::size_t j = 0; j < columns[x].weights.size(); ++j)
        sum += columns[x].weights[j] * in[columns[x].first + j];
      narrow[static_cast<std::size_t>(y) * to.width + x] = sum;
    }
  }
  GrayImage result{to, std::vector<std::uint8_t>(static_cast<std::size_t>(to.width) * to.height)};
  std::vector<float> row(to.width);
  for (int y = 0; y < to.height; ++y) {
    std::ranges::fill(row, 0.f);
    for (std::size_t j = 0; j < rows[y].weights.size(); ++j) {
      const float* in = &narrow[(rows[y].first + j) * to.width];
      for (int x = 0; x < to.width; ++x) row[x] += rows[y].weights[j] * in[x];
    }
    for (int x = 0; x < to.width; ++x)
      result.pixels[static_cast<std::size_t>(y) * to.width + x] =
          static_cast<std::uint8_t>(std::clamp(std::lround(row[x]), 0l, 255l));
  }
  return result;
}

GrayImage gray_of(const ImageSize& size, int channels, const std::uint8_t* pixels) {
  GrayImage gray{size, std::vector<std::uint8_t>(pixel_count(size))};
  for (std::size_t i = 0; i < gray.pixels.size(); ++i) {
    const std::uint8_t* p = &pixels[i * channels];
    gray.pixels[i] =
        channels < 3 ? p[0]
                     : static_cast<std::uint8_t>(std::lround(.2126f * p[0] + .7152f * p[1] + .0722f * p[2]));
  }
  return gray;
}

ImageSize gray_image_size(const std::filesystem::path& file) {
  const OIIO::ImageSpec spec = open_gray_image(file)->spec();
  return {spec.width, spec.height};
}

GrayImage read_gray_image(const std::filesystem::path& file) {
  const auto input = open_gray_image(file);
  const OIIO::ImageSpec& spec = input->spec();
  const int channels = spec.nchannels;
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(spec.width) * spec.height * channels);
  if (!input->read_image(0, 0, 0, channels, OIIO::TypeDesc::UINT8, pixels.data()))
    refuse_gray_image(file, input->geterror());
  return gray_of({spec.width, spec.height}, channels, pixels.data());
}

}  // namespace cps
