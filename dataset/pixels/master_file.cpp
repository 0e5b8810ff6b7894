#include "dataset/pixels/master_file.h"

#include <OpenImageIO/imagebufalgo.h>

#include <stdexcept>

#include "dataset/pixels/codec.h"

namespace cps {
namespace {

namespace algo = OIIO::ImageBufAlgo;

const std::vector<std::string> channel_names = {"R", "G", "B", "noise.R", "noise.G", "noise.B"};

}  // namespace

std::string encode_master(const NoisyMaster& master) {
  const OIIO::ImageBuf all =
      algo::clamp(algo::channel_append(master.picture, master.noise), -largest_half, largest_half);
  return encode_exr(all, OIIO::TypeDesc::HALF, channel_names);
}

NoisyMaster read_master(const std::filesystem::path& file) {
  try {
    const OIIO::ImageBuf all = channels_of(*open_image(file), OIIO::TypeDesc::FLOAT, channel_names);
    return {.picture = algo::channels(all, 3, {0, 1, 2}), .noise = algo::channels(all, 3, {3, 4, 5})};
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(file.string() + ": cannot be read as a master (" + error.what() +
                             "): make the dataset again");
  }
}

}  // namespace cps
