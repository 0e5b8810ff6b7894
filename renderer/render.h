#pragma once

#include <OpenImageIO/imagebuf.h>

#include <cstdint>
#include <string>

#include "renderer/camera.h"
#include "renderer/math/pixel_filter.h"
#include "renderer/paths/build_render_scene.h"
#include "renderer/tiles.h"

namespace cps {

class LightCache;

struct RenderOptions {
  int samples = 64;             ///< per pixel
  int max_shaded_vertices = 5;  ///< surface points at which a path gathers light; the ray that leaves the
                                ///< last one may still see the sky
  std::uint64_t seed = 0;
  PixelFilter filter = PixelFilter::box;
  LightCache* cache = nullptr;  ///< of the scene (light_cache.h); null: all light is traced
  TileProgress progress = {};   ///< called after every tile; may be empty

  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

struct RenderSummary {
  double wall_s = 0, cpu_s = 0;
  std::uint64_t samples = 0, rays = 0;

  /// One line for people: times, and samples and rays with their rates.
  std::string brief() const;
};

/// Linear Rec. 709 radiance, kcd/m², three float channels. A pure function of its arguments: the same bytes
/// for any number of threads (TBB decides how many). `variance`: of every pixel's mean, as if its samples
/// were independent, which overestimates it, since they are stratified. Throws std::runtime_error in one
/// line: a fault of the options, a camera without a size, a lens that is not one-to-one on the picture.
OIIO::ImageBuf render(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
                      RenderSummary* summary = nullptr, OIIO::ImageBuf* variance = nullptr);

/// Samples `first` … `first + count − 1` of every pixel's `options.samples`.
struct SampleRange {
  int first = 0, count = 0;
};

/// The same as the mean over a part of the samples, so that a picture can be refined step by step.
OIIO::ImageBuf render_samples(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
                              const SampleRange& range, RenderSummary* summary = nullptr,
                              OIIO::ImageBuf* variance = nullptr);

}  // namespace cps
