#include "apps/render/output_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <cstring>
#include <stdexcept>

#include "files/files.h"
#include "files/png.h"
#include "sensor/develop.h"

namespace cps {
namespace {

/// Names and types of all channels in a row.
OIIO::ImageSpec spec_of(const std::vector<ImageLayer>& layers) {
  OIIO::ImageSpec spec = layers.front().image.spec();
  spec.nchannels = 0;
  spec.channelnames.clear();
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const OIIO::ImageSpec& layer = layers[i].image.spec();
    for (const std::string& channel : layer.channelnames) {
      spec.channelnames.push_back(i == 0 ? channel : layers[i].name + "." + channel);
      spec.channelformats.push_back(layer.format);
      ++spec.nchannels;
    }
  }
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // not the clock: same arguments, same bytes
  return spec;
}

/// The layers' pixels side by side, each channel in its own type.
std::vector<char> interleaved(const std::vector<ImageLayer>& layers, std::size_t pixel_bytes) {
  const OIIO::ImageSpec& size = layers.front().image.spec();
  std::vector<char> pixels(pixel_bytes * size.image_pixels());
  std::size_t offset = 0;
  for (const ImageLayer& layer : layers) {
    const std::size_t bytes = layer.image.spec().pixel_bytes();
    const auto* from = static_cast<const char*>(layer.image.localpixels());
    for (std::size_t i = 0; i < size.image_pixels(); ++i)
      std::memcpy(&pixels[i * pixel_bytes + offset], from + i * bytes, bytes);
    offset += bytes;
  }
  return pixels;
}

}  // namespace

void write_exr(const std::filesystem::path& file, const std::vector<ImageLayer>& layers) {
  const OIIO::ImageSpec spec = spec_of(layers);
  const std::vector<char> pixels = interleaved(layers, spec.pixel_bytes(true));
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const auto out = OIIO::ImageOutput::create("picture.exr", &memory);
  if (!out || !out->open("picture.exr", spec) || !out->write_image(OIIO::TypeDesc::UNKNOWN, pixels.data()) ||
      !out->close()) {
    throw std::runtime_error(file.string() + ": " + (out ? out->geterror() : OIIO::geterror()));
  }
  write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void write_png(const std::filesystem::path& file, const OIIO::ImageBuf& linear, double exposure,
               std::uint64_t seed) {
  constexpr SensorSettings noiseless{.exposure_bias_ev = 0, .full_well_e = 1e15, .read_noise_e = 0};
  write_file(file, encode_png(develop(linear, exposure, noiseless, make_stream(seed, "sensor"))));
}

}  // namespace cps
