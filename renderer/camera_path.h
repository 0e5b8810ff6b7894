#pragma once

#include "renderer/camera_rays.h"
#include "renderer/paths/path.h"
#include "renderer/render.h"

namespace cps {

/// Where a picture's paths start.
struct PathSource {
  CameraRays rays;
  PixelFilter filter;
  std::uint64_t seed;
  float footprint;  ///< share of a pixel's width that texture lookups average over
};

/// Throws as make_camera_rays().
PathSource make_path_source(const Camera& camera, const RenderOptions& options);

/// Sample `index` of a pixel, at the beginning of its path.
Path camera_path(const PathSource& source, const CameraPixel& pixel, int x, int y, int index);

/// Where in the pixel its central ray passes, from the centre. An edge that two triangles share may run
/// exactly through the centres of pixels, and rays that meet it exactly can slip between the two.
inline const Eigen::Vector2f central_offset_px(1.0f / 4096, 1.0f / 8192);

/// The path through the pixel's centre, but for that: what the pixel shows where nothing may be averaged.
Path central_path(const PathSource& source, const CameraPixel& pixel, int x, int y);

}  // namespace cps
