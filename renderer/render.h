#pragma once

#include <OpenImageIO/imagebuf.h>

#include <cstdint>
#include <string>

#include "renderer/camera.h"
#include "renderer/math/pixel_filter.h"
#include "renderer/paths/build_render_scene.h"
#include "renderer/tiles.h"

namespace cps {

struct RenderOptions {
  int samples = 64;  ///< per pixel
  int max_shaded_vertices =
      5;  ///< surface points at which a path gathers light; the ray leaving the last may still see the sky
  std::uint64_t seed = 0;
  PixelFilter filter = PixelFilter::box;
  TileProgress progress = {};  ///< for people who wait
  bool is_valid(std::string* why) const;
};

struct RenderSummary {
  double wall_s = 0, cpu_s = 0;
  std::uint64_t samples = 0, rays = 0;
  std::string brief() const;
};

/// Linear Rec. 709 radiance, three float channels. A pure function of its arguments: the same bytes for any
/// number of threads (TBB decides how many). `variance`: of every pixel's mean, as if its samples were
/// independent; the Sobol points that they are do better. Throws std::runtime_error in one line: options, a
/// camera without a size, a lens that is not one-to-one on the picture.
OIIO::ImageBuf render(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
                      RenderSummary* summary = nullptr, OIIO::ImageBuf* variance = nullptr);

/// A part of every pixel's samples, so that a picture can be refined: its mean over samples `first` …
/// `first + count − 1` of the `options.samples` that it will have in the end.
struct SampleRange {
  int first = 0, count = 0;
};
OIIO::ImageBuf render_samples(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
                              const SampleRange& range, RenderSummary* summary = nullptr,
                              OIIO::ImageBuf* variance = nullptr);

}  // namespace cps
