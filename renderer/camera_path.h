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
  float footprint;  ///< fraction of a pixel's width that a texture lookup averages over
};

/// Throws as make_camera_rays() does.
PathSource make_path_source(const Camera& camera, const RenderOptions& options);

/// The start of the path of a pixel's sample `index`; not alive where the lens shows nothing.
Path camera_path(const PathSource& source, const CameraPixel& pixel, int x, int y, int index);

/// Offset of a pixel's central ray from the centre. An edge that two triangles share may run exactly through
/// the centres of pixels, and a ray that hits it exactly can slip between the two.
inline const Eigen::Vector2f central_offset_px(1.0f / 4096, 1.0f / 8192);

/// The path through the pixel's centre (plus central_offset_px), for what must not be averaged.
Path central_path(const PathSource& source, const CameraPixel& pixel, int x, int y);

/// Traces the paths that are alive to their ends, as the options say.
void trace_packet(const RenderScene& scene, const RenderOptions& options, Path (&paths)[packet_size]);

}  // namespace cps
