#include "trainer/images/master_cache.h"

#include <OpenImageIO/imagebufalgo.h>

#include <algorithm>
#include <cstring>
#include <stdexcept>

#include "dataset/pixels/master_file.h"
#include "trainer/images/places.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// Bytes of the picture or of the noise, as half floats.
std::size_t plane_bytes(const Pinhole& camera, int channels) {
  return static_cast<std::size_t>(camera.width) * camera.height * channels * sizeof(std::uint16_t);
}

/// All that the cached pixels depend on.
std::string cache_key(const std::vector<KeptMaster>& masters, int channels) {
  std::string key = "cps masters 2\nchannels " + std::to_string(channels) + "\n";
  for (const KeptMaster& m : masters)
    key += m.file.string() + " " + m.sha256 + " " + std::to_string(m.camera.width) + "x" +
           std::to_string(m.camera.height) + "\n";
  return key;
}

/// Reads a master as half floats: rows of the picture, then of the noise.
void read_halves(const fs::path& file, const Pinhole& camera, int channels, std::span<std::uint8_t> out) {
  const NoisyMaster master = read_master(file);
  const OIIO::ImageSpec& spec = master.picture.spec();
  if (spec.width != camera.width || spec.height != camera.height)
    throw std::runtime_error(file.string() +
                             ": is not of the size that masters.csv says: make the dataset again");
  for (const OIIO::ImageBuf* plane : {&master.picture, &master.noise}) {
    const OIIO::ImageBuf gray = channels == 1 ? luminance(*plane) : OIIO::ImageBuf();
    const OIIO::ImageBuf& kept = channels == 1 ? gray : *plane;
    kept.get_pixels(kept.roi(), OIIO::TypeDesc::HALF, out.data());
    out = out.subspan(plane_bytes(camera, channels));
  }
}

}  // namespace

Master MasterCache::master(int i) const {
  const Pinhole& camera = masters[i].camera;
  const auto plane = [&](std::size_t offset) {
    const OIIO::ImageSpec half(camera.width, camera.height, channels, OIIO::TypeDesc::HALF);
    // The memory is mapped for reading; nothing writes to the buffer.
    const OIIO::ImageBuf mapped(half, const_cast<std::uint8_t*>(pixels.blobs[i].data() + offset));
    return mapped.copy(OIIO::TypeDesc::FLOAT);
  };
  return {.camera = camera,
          .light = {.picture = plane(0), .noise = plane(plane_bytes(camera, channels))},
          .exposure = masters[i].exposure};
}

MasterCache load_master_cache(const fs::path& dataset, Part part, bool as_luminance, bool skip_bad,
                              const fs::path& file, double places_share) {
  MasterCache cache{.masters = {}, .channels = as_luminance ? 1 : 3, .pixels = {}, .skipped = {}};
  for (KeptMaster& master : read_masters(dataset))
    if (master.part == part) cache.masters.push_back(std::move(master));
  cache.masters = share_of_places(cache.masters, places_share);
  while (!cache.masters.empty()) try {
      std::vector<std::size_t> sizes;
      for (const KeptMaster& m : cache.masters) sizes.push_back(2 * plane_bytes(m.camera, cache.channels));
      cache.pixels = load_blob_cache(
          cache_key(cache.masters, cache.channels), sizes,
          [&](std::size_t i, std::span<std::uint8_t> out) {
            read_halves(dataset / cache.masters[i].file, cache.masters[i].camera, cache.channels, out);
          },
          file);
      return cache;
    } catch (const BadBlobs& bad) {
      if (!skip_bad) throw;
      leave_out(bad, cache.masters, cache.skipped);
    }
  throw std::runtime_error((dataset / "masters.csv").string() + ": lists no master of the " +
                           to_string(part) + " part that can be used");
}

}  // namespace cps
