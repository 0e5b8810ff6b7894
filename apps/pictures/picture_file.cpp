#include "apps/pictures/picture_file.h"

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <stdexcept>

#include "files/files.h"
#include "renderer/materials/srgb.h"

namespace fs = std::filesystem;

namespace cps {
namespace {

[[noreturn]] void fail(const fs::path& file, const std::string& what) {
  // Messages of OpenImageIO may have several lines.
  std::string line = what.substr(0, what.find('\n'));
  throw std::runtime_error(file.string() + ": " + line);
}

std::unique_ptr<OIIO::ImageInput> open(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) fail(file, "there is no such file");
  OIIO::ImageSpec keep_alpha;
  keep_alpha.attribute("oiio:UnassociatedAlpha", 1);
  auto input = OIIO::ImageInput::open(file.string(), &keep_alpha);
  if (!input) fail(file, "is not a picture that can be read: " + OIIO::geterror());
  return input;
}

/// Whether the file ends before its image does. libjpeg fills the missing part with gray without an error.
bool is_truncated_jpeg(const std::string& bytes) {
  const auto last = [&](const char* marker) { return bytes.rfind(marker); };
  return last("\xff\xd9") == std::string::npos ||
         (last("\xff\xda") != std::string::npos && last("\xff\xd9") < last("\xff\xda"));
}

/// Applies `change(value, alpha)` to all channels other than alpha.
template <typename Change>
void change_colours(OIIO::ImageBuf& image, int alpha, Change change) {
  const OIIO::ImageSpec& spec = image.spec();
  tbb::parallel_for(0, spec.height, [&](int y) {
    auto* pixel = static_cast<float*>(image.pixeladdr(spec.x, spec.y + y));
    for (int x = 0; x < spec.width; ++x, pixel += spec.nchannels)
      for (int channel = 0; channel < spec.nchannels; ++channel)
        if (channel != alpha) pixel[channel] = change(pixel[channel], alpha < 0 ? 1.0f : pixel[alpha]);
  });
}

/// Whether the file's colours are not yet multiplied by its alpha. In a file of data, alpha is data too.
bool is_unassociated(const OIIO::ImageSpec& file, bool is_srgb) {
  return is_srgb && file.alpha_channel >= 0 && file.get_int_attribute("oiio:UnassociatedAlpha") != 0;
}

bool is_encoded(const OIIO::ImageSpec& file, Encoding encoding) {
  if (encoding != Encoding::automatic) return encoding == Encoding::srgb;
  return !file.format.is_floating_point() &&
         !OIIO::Strutil::iequals(file.get_string_attribute("oiio:ColorSpace"), "Linear");
}

}  // namespace

Encoding encoding_from_string(const std::string& word) {
  if (word == "auto") return Encoding::automatic;
  if (word == "srgb") return Encoding::srgb;
  if (word == "linear") return Encoding::linear;
  throw std::runtime_error("is none of auto, srgb, linear");
}

OIIO::ImageSpec read_picture_header(const fs::path& file) {
  return open(file)->spec();
}

Picture read_picture(const fs::path& file, Encoding encoding, Resampling resampling, int width, int height) {
  const auto input = open(file);
  Picture picture;
  picture.file = input->spec();
  const OIIO::ImageSpec& spec = picture.file;
  if (spec.width != width || spec.height != height)
    fail(file, "is " + std::to_string(spec.width) + " x " + std::to_string(spec.height) +
                   " pixels, its camera " + std::to_string(width) + " x " + std::to_string(height));
  if (spec.nchannels < 1 || spec.nchannels > 4)
    fail(file, "has " + std::to_string(spec.nchannels) + " channels; 1 to 4 are supported");
  if (spec.deep || spec.depth > 1) fail(file, "is deep or a volume, not a picture");
  if (spec.x != 0 || spec.y != 0 || spec.full_width != spec.width || spec.full_height != spec.height)
    fail(file, "its data window is not its display window: cut or pad it first");
  if (input->seek_subimage(1, 0)) fail(file, "holds several pictures: split it first");
  input->seek_subimage(0, 0);
  if (std::string_view(input->format_name()) == "jpeg" && is_truncated_jpeg(read_file(file)))
    fail(file, "is damaged: the JPEG ends too early");

  const bool filtered = resampling == Resampling::footprint;
  const OIIO::TypeDesc type = filtered ? OIIO::TypeDesc(OIIO::TypeFloat) : spec.format;
  picture.pixels = OIIO::ImageBuf(OIIO::ImageSpec(width, height, spec.nchannels, type));
  if (!input->read_image(0, 0, 0, spec.nchannels, type, picture.pixels.localpixels()))
    fail(file, "is damaged: " + input->geterror());
  if (!filtered) return picture;
  picture.is_srgb = is_encoded(spec, encoding);
  if (picture.is_srgb)
    change_colours(picture.pixels, spec.alpha_channel,
                   [](float value, float) { return static_cast<float>(linear_from_srgb(value)); });
  if (is_unassociated(spec, picture.is_srgb))
    change_colours(picture.pixels, spec.alpha_channel,
                   [](float value, float alpha) { return value * alpha; });
  return picture;
}

void write_picture(const fs::path& file, const OIIO::ImageBuf& pixels, const Picture& source) {
  OIIO::ImageBuf encoded = pixels;
  if (is_unassociated(source.file, source.is_srgb))
    change_colours(encoded, source.file.alpha_channel,
                   [](float value, float alpha) { return alpha > 0 ? value / alpha : 0; });
  if (source.is_srgb)
    change_colours(encoded, source.file.alpha_channel, [](float value, float) {
      return static_cast<float>(srgb_from_linear(std::max(0.0f, value)));
    });

  OIIO::ImageSpec spec(pixels.spec().width, pixels.spec().height, source.file.nchannels, source.file.format);
  spec.channelnames = source.file.channelnames;
  spec.alpha_channel = source.file.alpha_channel;
  spec.z_channel = source.file.z_channel;
  spec.extra_attribs = source.file.extra_attribs;
  // Fast deflate: a third more bytes than the best level in a tenth of the time. Other formats ignore both
  // attributes.
  spec.attribute("png:compressionLevel", 1);
  spec.attribute("png:filter", 32);  // PNG_FILTER_UP
  const auto output = OIIO::ImageOutput::create(file.string());
  if (!output) fail(file, "cannot be written: " + OIIO::geterror());
  if (std::string_view(output->format_name()) == "jpeg") spec.attribute("Compression", "jpeg:95");
  write_by_rename(file, [&](const fs::path& temporary) {
    if (!output->open(temporary.string(), spec) ||
        !output->write_image(encoded.spec().format, encoded.localpixels()) || !output->close()) {
      const std::string why = output->geterror();
      throw std::runtime_error(why.substr(0, why.find('\n')));
    }
  });
}

}  // namespace cps
