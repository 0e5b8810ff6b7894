#include <OpenImageIO/imageio.h>

#include <cstring>
#include <stdexcept>

#include "apps/pictures/colour_channels.h"
#include "apps/pictures/dpx_header.h"
#include "apps/pictures/jpeg_end.h"
#include "apps/pictures/netpbm16.h"
#include "apps/pictures/picture_file.h"
#include "apps/pictures/picture_format.h"
#include "files/files.h"
#include "numbers/srgb.h"

namespace fs = std::filesystem;

namespace cps {
namespace {

std::unique_ptr<OIIO::ImageInput> open(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) refuse_picture(file, "there is no such file");
  check_dpx_header(file);
  OIIO::ImageSpec keep_alpha;
  keep_alpha.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(file.string(), &keep_alpha);
  if (!input) refuse_picture(file, "is not a picture that can be read: " + OIIO::geterror());
  return input;
}

/// The EXIF orientation, 1 (upright) to 8.
int orientation_of(const OIIO::ImageSpec& spec) {
  const int orientation = spec.get_int_attribute("Orientation", 1);
  return orientation >= 1 && orientation <= 8 ? orientation : 1;
}

ImageSize upright(const OIIO::ImageSpec& spec) {
  constexpr int first_on_its_side = 5;
  if (orientation_of(spec) >= first_on_its_side) return {spec.height, spec.width};
  return {spec.width, spec.height};
}

/// Turns pixels and header upright. EXIF 2.3, tag 0x112: first rows and columns change places, then sides.
/// (OpenImageIO 2.4 turns the mirrored ones that lie on their side, 5 and 7, another way.)
void turn_upright(Picture& picture) {
  const int orientation = orientation_of(picture.file);
  if (orientation == 1) return;
  const bool is_transposed = orientation >= 5,
             is_flipped_x = orientation == 2 || orientation == 3 || orientation == 6 || orientation == 7,
             is_flipped_y = orientation == 3 || orientation == 4 || orientation >= 7;
  const auto [width, height] = upright(picture.file);
  OIIO::ImageSpec spec = picture.pixels.spec();
  spec.width = spec.full_width = width;
  spec.height = spec.full_height = height;
  OIIO::ImageBuf turned(spec);
  const std::size_t bytes = spec.pixel_bytes();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const int column = is_flipped_x ? width - 1 - x : x, row = is_flipped_y ? height - 1 - y : y;
      const void* from =
          is_transposed ? picture.pixels.pixeladdr(row, column) : picture.pixels.pixeladdr(column, row);
      std::memcpy(turned.pixeladdr(x, y), from, bytes);
    }
  picture.pixels = turned;
  picture.file.attribute("Orientation", 1);
  picture.was_turned = true;
}

bool is_encoded(const OIIO::ImageSpec& file, Encoding encoding) {
  if (encoding != Encoding::automatic) return encoding == Encoding::srgb;
  return !file.format.is_floating_point() &&
         !OIIO::Strutil::iequals(file.get_string_attribute("oiio:ColorSpace"), "Linear");
}

void check_header(const fs::path& file, OIIO::ImageInput& input, int width, int height) {
  const OIIO::ImageSpec& spec = input.spec();
  const ImageSize size = upright(spec);
  if (size != ImageSize{width, height})
    refuse_picture(file, "is " + std::to_string(size.width) + " x " + std::to_string(size.height) +
                             " pixels" +
                             (orientation_of(spec) == 1 ? "" : " upright, as its EXIF orientation says") +
                             ", its camera " + std::to_string(width) + " x " + std::to_string(height));
  if (spec.nchannels < 1 || spec.nchannels > 4)
    refuse_picture(file, "has " + std::to_string(spec.nchannels) + " channels; 1 to 4 are supported");
  if (spec.deep || spec.depth > 1) refuse_picture(file, "is deep or a volume, not a picture");
  if (spec.x != 0 || spec.y != 0 || spec.full_width != spec.width || spec.full_height != spec.height)
    refuse_picture(file, "its data window is not its display window: cut or pad it first");
  for (const OIIO::TypeDesc& type : spec.channelformats)
    if (type != spec.format) refuse_picture(file, "its channels have different pixel types: split it first");
  if (input.seek_subimage(1, 0)) refuse_picture(file, "holds several pictures: split it first");
  input.seek_subimage(0, 0);
  if (std::string_view(input.format_name()) == "jpeg" && !has_whole_image(read_file(file)))
    refuse_picture(file, "is damaged: the JPEG ends too early");
}

/// Makes colours linear and multiplies them by alpha. In a file of data, alpha is data too.
void to_light(Picture& picture, Encoding encoding) {
  const int alpha = picture.file.alpha_channel;
  picture.is_srgb = is_encoded(picture.file, encoding);
  if (picture.is_srgb)
    change_colours(picture.pixels, alpha,
                   [](float value, float) { return static_cast<float>(linear_from_srgb(value)); });
  const bool is_straight = picture.file.get_int_attribute("oiio:UnassociatedAlpha") != 0;
  picture.is_premultiplied = alpha >= 0 && (picture.is_srgb || !is_straight);
  if (picture.is_premultiplied && is_straight)
    change_colours(picture.pixels, alpha, [](float value, float alpha) { return value * alpha; });
}

}  // namespace

Encoding encoding_from_string(const std::string& word) {
  if (word == "auto") return Encoding::automatic;
  if (word == "srgb") return Encoding::srgb;
  if (word == "linear") return Encoding::linear;
  throw std::runtime_error("is none of auto, srgb, linear");
}

ImageSize upright_size(const fs::path& file) {
  return upright(open(file)->spec());
}

Picture read_picture(const fs::path& file, Encoding encoding, Resampling resampling, int width, int height) {
  const auto input = open(file);
  check_header(file, *input, width, height);
  const OIIO::ImageSpec& spec = input->spec();
  Picture picture{
      .pixels = {}, .file = spec, .encoding = encoding, .is_light = resampling == Resampling::footprint};
  if (!picture.is_light && is_palette_png(file)) {
    picture.pixels = read_palette_png(file, picture.palette);
  } else if (!picture.is_light && is_netpbm16(file)) {
    picture.pixels = read_netpbm16(file);
  } else {
    const OIIO::TypeDesc type = picture.is_light ? OIIO::TypeDesc(OIIO::TypeFloat) : spec.format;
    picture.pixels = OIIO::ImageBuf(OIIO::ImageSpec(spec.width, spec.height, spec.nchannels, type));
    if (!input->read_image(0, 0, 0, spec.nchannels, type, picture.pixels.localpixels()))
      refuse_picture(file, "is damaged: " + input->geterror());
  }
  turn_upright(picture);
  if (picture.is_light) to_light(picture, encoding);
  return picture;
}

}  // namespace cps
