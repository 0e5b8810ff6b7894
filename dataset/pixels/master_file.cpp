#include "dataset/pixels/master_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

namespace cps {
namespace {

namespace algo = OIIO::ImageBufAlgo;

constexpr float largest_half = 65504;
const std::array<std::string, 6> channel_names = {"R", "G", "B", "noise.R", "noise.G", "noise.B"};

[[noreturn]] void fail(const std::filesystem::path& file, std::string why) {
  std::ranges::replace(why, '\n', ' ');
  throw std::runtime_error(file.string() + ": cannot be read as a master (" + why +
                           "): make the dataset again");
}

}  // namespace

std::string encode_master(const NoisyMaster& master) {
  const OIIO::ImageBuf all =
      algo::clamp(algo::channel_append(master.picture, master.noise), -largest_half, largest_half);
  OIIO::ImageSpec spec(all.spec().width, all.spec().height, 6, OIIO::TypeDesc::HALF);
  spec.channelnames.assign(channel_names.begin(), channel_names.end());
  spec.attribute("compression", "zip");
  spec.attribute("DateTime", "1970:01:01 00:00:00");  // otherwise OpenImageIO writes the time of day
  std::vector<unsigned char> bytes;
  OIIO::Filesystem::IOVecOutput memory(bytes);
  const std::unique_ptr<OIIO::ImageOutput> out = OIIO::ImageOutput::create("exr");
  if (!out || !out->set_ioproxy(&memory) || !out->open("master.exr", spec) ||
      !out->write_image(OIIO::TypeDesc::FLOAT, all.localpixels()) || !out->close())
    throw std::runtime_error("exr encoding failed: " + (out ? out->geterror() : OIIO::geterror()));
  return {bytes.begin(), bytes.end()};
}

NoisyMaster read_master(const std::filesystem::path& file) {
  const std::unique_ptr<OIIO::ImageInput> in = OIIO::ImageInput::open(file.string());
  if (!in) fail(file, OIIO::geterror());
  const OIIO::ImageSpec& spec = in->spec();
  OIIO::ImageBuf all(OIIO::ImageSpec(spec.width, spec.height, spec.nchannels, OIIO::TypeDesc::FLOAT));
  if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, all.localpixels()))
    fail(file, in->geterror());
  std::array<int, 6> order;  // EXR stores channels in an order of its own
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = spec.channelindex(channel_names[i]);
    if (order[i] < 0) fail(file, "channel " + channel_names[i] + " is missing");
  }
  return {.picture = algo::channels(all, 3, {order.data(), 3}),
          .noise = algo::channels(all, 3, {order.data() + 3, 3})};
}

}  // namespace cps
