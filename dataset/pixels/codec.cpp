#include "dataset/pixels/codec.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <stdexcept>

namespace cps {
namespace {

[[noreturn]] void fail(std::string why) {
  std::ranges::replace(why, '\n', ' ');
  throw std::runtime_error(why);
}

}  // namespace

std::string encode_by_oiio(const std::string& kind, const OIIO::ImageSpec& spec,
                           const OIIO::ImageBuf& image) {
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create(kind);
  const bool is_written = out && out->set_ioproxy(&memory) && out->open("image." + kind, spec) &&
                          out->write_image(image.spec().format, image.localpixels()) && out->close();
  if (!is_written) fail(kind + " encoding failed: " + (out ? out->geterror() : OIIO::geterror()));
  return {bytes.begin(), bytes.end()};
}

std::string encode_exr(const OIIO::ImageBuf& image, OIIO::TypeDesc type,
                       const std::vector<std::string>& channels) {
  const int count = static_cast<int>(channels.size());
  if (image.nchannels() != count)
    fail("exr encoding failed: needs " + std::to_string(count) + " channels, has " +
         std::to_string(image.nchannels()));
  OIIO::ImageSpec spec(image.spec().width, image.spec().height, count, type);
  spec.channelnames = channels;
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // otherwise OpenImageIO writes the time of day
  return encode_by_oiio("exr", spec, image);
}

std::unique_ptr<OIIO::ImageInput> open_image(const std::filesystem::path& file,
                                             OIIO::Filesystem::IOProxy* memory) {
  // Not by an ImageBuf of that name: its cache may still hold an older file.
  std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(file.string(), nullptr, memory);
  if (!in) fail(OIIO::geterror());
  return in;
}

OIIO::ImageBuf pixels_of(OIIO::ImageInput& in, OIIO::TypeDesc type) {
  const OIIO::ImageSpec& spec = in.spec();
  OIIO::ImageBuf pixels(OIIO::ImageSpec(spec.width, spec.height, spec.nchannels, type));
  if (!in.read_image(0, 0, 0, spec.nchannels, type, pixels.localpixels())) fail(in.geterror());
  return pixels;
}

OIIO::ImageBuf channels_of(OIIO::ImageInput& in, OIIO::TypeDesc type,
                           const std::vector<std::string>& channels) {
  std::vector<int> order;
  for (const std::string& channel : channels) {
    order.push_back(in.spec().channelindex(channel));
    if (order.back() < 0) fail("channel " + channel + " is missing");
  }
  return OIIO::ImageBufAlgo::channels(pixels_of(in, type), static_cast<int>(order.size()), order, {},
                                      channels);
}

}  // namespace cps
