#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <stdexcept>

#include "apps/pictures/colour_channels.h"
#include "apps/pictures/netpbm16.h"
#include "apps/pictures/picture_file.h"
#include "apps/pictures/picture_format.h"
#include "files/files.h"
#include "numbers/srgb.h"

namespace fs = std::filesystem;

namespace cps {
namespace {

bool writes_srgb(const Picture& source, OIIO::TypeDesc stored) {
  if (source.encoding != Encoding::automatic) return source.encoding == Encoding::srgb;
  if (stored.is_floating_point() == source.file.format.is_floating_point()) return source.is_srgb;
  return !stored.is_floating_point();
}

bool writes_straight_alpha(const PictureFormat& format, const Picture& source) {
  if (format.alpha == AlphaKind::either) return source.file.get_int_attribute("oiio:UnassociatedAlpha") != 0;
  return format.alpha == AlphaKind::straight;
}

/// Pixels as the file holds them.
OIIO::ImageBuf encode(const OIIO::ImageBuf& pixels, const Picture& source, bool to_srgb, bool to_straight) {
  OIIO::ImageBuf encoded = pixels;
  if (source.is_premultiplied && to_straight)
    change_colours(encoded, source.file.alpha_channel,
                   [](float value, float alpha) { return alpha > 0 ? value / alpha : 0; });
  if (to_srgb)
    change_colours(encoded, source.file.alpha_channel, [](float value, float) {
      return static_cast<float>(srgb_from_linear(std::max(0.0f, value)));
    });
  return encoded;
}

std::string pixel_kind(const OIIO::ImageSpec& spec) {
  return std::to_string(spec.nchannels) + " channels of type " + spec.format.c_str();
}

/// Writers of some formats store something simpler than they are given, and say nothing.
void check_stored(const fs::path& written, const OIIO::ImageSpec& wanted) {
  const auto stored = OIIO::ImageInput::open(written.string());
  if (!stored) throw std::runtime_error("the format's writer left no picture");
  const OIIO::ImageSpec& spec = stored->spec();
  if (spec.width != wanted.width || spec.height != wanted.height || spec.nchannels != wanted.nchannels ||
      spec.format != wanted.format)
    throw std::runtime_error("the format has no place for " + pixel_kind(wanted) +
                             ": choose .png, .tif or .exr");
}

void write_and_check(OIIO::ImageOutput& output, const fs::path& file, const OIIO::ImageSpec& spec,
                     const OIIO::ImageBuf& encoded) {
  if (!output.open(file.string(), spec) ||
      !output.write_image(encoded.spec().format, encoded.localpixels()) || !output.close()) {
    const std::string why = output.geterror();
    throw std::runtime_error(why.substr(0, why.find('\n')));
  }
  check_stored(file, spec);
}

}  // namespace

void write_picture(const fs::path& file, const OIIO::ImageBuf& pixels, const Picture& source) {
  const PictureFormat* format = picture_format(file);
  if (format == nullptr) refuse_picture(file, "cps writes no such format: choose .png, .jpg, .tif or .exr");
  if (!source.palette.empty()) {
    if (file.extension() != ".png")
      refuse_picture(file, "the ids are numbers of a palette, which needs a .png");
    write_by_rename(file,
                    [&](const fs::path& temporary) { write_palette_png(temporary, pixels, source.palette); });
    return;
  }
  if (!source.is_light && !format->is_lossless)
    refuse_picture(file, "the format changes values; ids and depth need .png, .tif or .exr");
  const auto type = stored_type(*format, source.file.format, source.is_light);
  if (!type)
    refuse_picture(file,
                   "the format has no place for " + pixel_kind(source.file) + ": choose .png, .tif or .exr");
  const bool to_srgb = source.is_light && writes_srgb(source, *type),
             to_straight = writes_straight_alpha(*format, source);

  OIIO::ImageSpec spec(pixels.spec().width, pixels.spec().height, source.file.nchannels, *type);
  spec.channelnames = source.file.channelnames;
  spec.alpha_channel = source.file.alpha_channel;
  spec.z_channel = source.file.z_channel;
  spec.extra_attribs = source.file.extra_attribs;
  // These describe the file that was read.
  for (const char* name : {"oiio:ColorSpace", "oiio:BitsPerSample", "oiio:UnassociatedAlpha"})
    spec.erase_attribute(name);
  if (source.is_light) spec.attribute("oiio:ColorSpace", to_srgb ? "sRGB" : "Linear");
  if (to_straight) spec.attribute("oiio:UnassociatedAlpha", 1);
  // Fast deflate: a third more bytes than the best level in a tenth of the time. Other formats ignore both
  // attributes.
  spec.attribute("png:compressionLevel", 1);
  spec.attribute("png:filter", 32);  // PNG_FILTER_UP
  const auto output = OIIO::ImageOutput::create(file.string());
  if (!output) refuse_picture(file, "cannot be written: " + OIIO::geterror());
  if (std::string_view(output->format_name()) == "jpeg") spec.attribute("Compression", "jpeg:95");
  const OIIO::ImageBuf encoded = source.is_light ? encode(pixels, source, to_srgb, to_straight) : pixels;
  if (output->format_name() == std::string_view("pnm") && *type == OIIO::TypeDesc::UINT16 &&
      (spec.nchannels == 1 || spec.nchannels == 3))
    return write_netpbm16(file, encoded);
  write_by_rename(file, [&](const fs::path& temporary) {
    // JPEG 2000's writer looks at the extension, which a temporary name does not have.
    const fs::path named = temporary.string() + file.extension().string();
    try {
      write_and_check(*output, named, spec, encoded);
      fs::rename(named, temporary);
    } catch (...) {
      std::error_code ignored;
      fs::remove(named, ignored);
      throw;
    }
  });
}

}  // namespace cps
