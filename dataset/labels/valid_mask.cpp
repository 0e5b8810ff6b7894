#include "dataset/labels/valid_mask.h"

#include <tbb/parallel_for.h>

#include <cstring>
#include <vector>

#include "distortion/models/inverse/region_inverse.h"
#include "distortion/models/warp/proved_camera.h"

namespace cps {
namespace {

constexpr int kernel_nodes = 3;  ///< side of a pixel's kernel, pixels

/// Whether the lens shows each node of a grid: the corners of all kernels. They lie a pixel apart; the first
/// is that of the first pixel's kernel.
template <typename Lens>
std::vector<std::uint8_t> seen_nodes(const Lens& lens, const RayRegion& region, const Pinhole& pinhole) {
  const RegionInverse<Lens> inverse(lens, region);
  const int columns = pinhole.width + kernel_nodes, rows = pinhole.height + kernel_nodes;
  std::vector<std::uint8_t> seen(static_cast<std::size_t>(columns) * rows);
  tbb::parallel_for(0, rows, [&](int row) {
    for (int column = 0; column < columns; ++column) {
      const Eigen::Vector2d pixel(column - 0.5 * kernel_nodes, row - 0.5 * kernel_nodes);
      seen[static_cast<std::size_t>(row) * columns + column] =
          inverse(to_plane(pinhole, pixel)).has_value() ? 1 : 0;
    }
  });
  return seen;
}

}  // namespace

std::optional<OIIO::ImageBuf> valid_mask(const ModelCamera& camera) {
  const Pinhole& pinhole = camera.pinhole;
  // The frame with all kernels of its pixels.
  const ModelCertificate proof = certify_frame({{}, oversampled(pinhole, 1, 1), camera.lens}, one_to_one);
  if (proof.valid) return std::nullopt;
  OIIO::ImageBuf mask(OIIO::ImageSpec(pinhole.width, pinhole.height, 1, OIIO::TypeDesc::UINT8));
  if (is_empty(proof.region)) return mask;
  const std::vector<std::uint8_t> seen =
      std::visit([&](const auto& lens) { return seen_nodes(lens, proof.region, pinhole); }, camera.lens);
  const auto at = [&](int column, int row) {
    return seen[static_cast<std::size_t>(row) * (pinhole.width + kernel_nodes) + column];
  };
  auto* value = static_cast<std::uint8_t*>(mask.localpixels());
  bool is_all_valid = true;
  for (int y = 0; y < pinhole.height; ++y)
    for (int x = 0; x < pinhole.width; ++x, ++value) {
      // What a lens shows is convex: a disc, or a part of one. So the corners tell of the whole square.
      const bool is_valid = at(x, y) && at(x + kernel_nodes, y) && at(x, y + kernel_nodes) &&
                            at(x + kernel_nodes, y + kernel_nodes);
      *value = is_valid ? 255 : 0;
      is_all_valid = is_all_valid && is_valid;
    }
  return is_all_valid ? std::nullopt : std::optional(std::move(mask));
}

void black_out(OIIO::ImageBuf& image, const OIIO::ImageBuf& mask) {
  const auto* valid = static_cast<const std::uint8_t*>(mask.localpixels());
  auto* pixels = static_cast<char*>(image.localpixels());
  const std::size_t pixel_bytes = image.spec().pixel_bytes();
  for (std::size_t i = 0; i < image.spec().image_pixels(); ++i)
    if (valid[i] == 0) std::memset(pixels + i * pixel_bytes, 0, pixel_bytes);
}

}  // namespace cps
