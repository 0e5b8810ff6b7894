#include "trainer/evaluation/page/picture_svg.h"

#include <OpenImageIO/imagebuf.h>
#include <fmt/format.h>

#include <stdexcept>

#include "files/data_uri.h"
#include "files/png.h"
#include "trainer/images/gray_image.h"

namespace cps {
namespace {

/// Empty if the file cannot be read.
std::string gray_png_uri(const std::filesystem::path& file, int width_px) {
  try {
    const GrayImage whole = read_gray_image(file);
    const GrayImage gray = area_average(whole, reduced_size(whole.size, {.width = width_px}));
    OIIO::ImageBuf pixels(OIIO::ImageSpec(gray.size.width, gray.size.height, 1, OIIO::TypeDesc::UINT8));
    pixels.set_pixels(OIIO::ROI::All(), OIIO::TypeDesc::UINT8, gray.pixels.data());
    return data_uri("image/png", encode_png(pixels));
  } catch (const std::exception&) {
    return "";
  }
}

}  // namespace

std::string picture_svg(const EvaluationImage& image, int width_px, double picture_opacity,
                        const std::string& drawing) {
  const Pinhole& camera = image.truth.pinhole;
  const std::string uri = gray_png_uri(image.file, width_px);
  const std::string picture =
      uri.empty() ? ""
                  : fmt::format(
                        "<image href=\"{}\" width=\"{}\" height=\"{}\" preserveAspectRatio=\"none\" "
                        "opacity=\"{:g}\"/>\n",
                        uri, camera.width, camera.height, picture_opacity);
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" width=\"{}\">\n{}{}</svg>\n",
      camera.width, camera.height, width_px, picture, drawing);
}

}  // namespace cps
