#pragma once

#include <OpenImageIO/imagebuf.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <string>

#include "distortion/pinhole.h"
#include "scenes/daylight.h"
#include "scenes/scene.h"

namespace cps {

/// A scene ready to be traced under one light: BVH, mip pyramids, sky tables. Built once per condition, then
/// read-only.
struct RenderScene;
std::shared_ptr<const RenderScene> build_render_scene(const Scene& scene, const Daylight& daylight);

/// An ideal camera in the world. Camera frame: x right, y down, z forward.
struct Camera {
  Eigen::Isometry3d world_from_camera = Eigen::Isometry3d::Identity();
  Pinhole pinhole;
};

struct RenderOptions {
  int samples = 64;  ///< per pixel
  int max_shaded_vertices =
      5;  ///< surface points at which a path gathers light; the ray leaving the last may still see the sky
  std::uint64_t seed = 0;
  bool is_valid(std::string* why) const;
};

struct RenderSummary {
  double wall_s = 0, cpu_s = 0;
  std::uint64_t samples = 0, rays = 0;
  std::string brief() const;
};

/// Linear Rec. 709 radiance, three float channels, box-filtered pixels. A pure function of its arguments: the
/// same bytes for any number of threads (TBB decides how many).
OIIO::ImageBuf render(const RenderScene& scene, const Camera& camera, const RenderOptions& options,
                      RenderSummary* summary = nullptr);

}  // namespace cps
