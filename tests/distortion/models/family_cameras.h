#pragma once

#include <OpenImageIO/imagebuf.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "distortion/models/inverse/unproject.h"
#include "distortion/models/projection.h"
#include "distortion/warp/warp_options.h"

namespace cps {

/// A camera with this lens that shows `focal` pixels per radian in its middle. Pixels are not square, and the
/// principal point is off the centre.
inline ModelCamera family_camera(const LensModel& lens, int width, int height, double focal) {
  const double middle = project(lens, Eigen::Vector3d::UnitZ()).jacobian(0, 0);
  const Pinhole pinhole{width,           height,          focal / middle, 1.02 * focal / middle,
                        0.5 * width + 1, 0.5 * height - 2};
  return {std::string(family_name(lens)), pinhole, lens};
}

/// One such camera of every family. Each shows 70° and more off the axis, or as much as a plane can.
inline std::vector<ModelCamera> family_cameras(int width, int height, double focal) {
  const LensModel lenses[]{
      Distortion{.k1 = -0.1, .k2 = 0.01, .p1 = 0.001, .p2 = -0.0005},
      RationalLens{.k1 = 0.1, .k2 = 0.02, .k4 = 0.25, .k5 = 0.04, .p1 = 0.0005, .p2 = -0.001},
      KannalaBrandt{.k1 = -0.02, .k2 = 0.003, .k3 = -0.001},
      UnifiedSpherical{.xi = 0.9, .distortion = {.k1 = -0.05, .k2 = 0.01, .p1 = 0.0005, .p2 = 0.0005}},
      Eucm{.alpha = 0.6, .beta = 1.1},
      DoubleSphere{.xi = -0.2, .alpha = 0.55}};
  std::vector<ModelCamera> cameras;
  for (const LensModel& lens : lenses) cameras.push_back(family_camera(lens, width, height, focal));
  return cameras;
}

/// The region of a camera whose lens is proved on its frame.
inline RayRegion proved_region(const ModelCamera& camera) {
  const ModelCertificate proof = certify_frame(camera, warpable);
  INFO(camera.name << ": " << proof.why);
  REQUIRE(proof.valid);
  return proof.region;
}

/// A smooth picture of the world, a function of the unit direction. Its gradient is below 1.2 per radian and
/// its Laplacian below 5 per square radian.
inline double smooth_scene(const Eigen::Vector3d& direction) {
  const double x = direction.x(), y = direction.y(), z = direction.z();
  return 0.5 + 0.2 * std::sin(3 * x + z) + 0.15 * std::cos(2 * y - 1.5 * z + 0.5 * x);
}

/// The ray through a position of the image, camera frame.
inline Eigen::Vector3d ray_at(const ModelCamera& camera, const RayRegion& region,
                              const Eigen::Vector2d& pixel) {
  const auto ray = unproject(camera.lens, region, to_plane(camera.pinhole, pixel));
  REQUIRE(ray);
  return *ray;
}

/// The scene at the rays through the camera's pixel centres.
inline OIIO::ImageBuf photograph_scene(const ModelCamera& camera) {
  const RayRegion region = proved_region(camera);
  OIIO::ImageBuf image(OIIO::ImageSpec(camera.pinhole.width, camera.pinhole.height, 1, OIIO::TypeFloat));
  for (int y = 0; y < camera.pinhole.height; ++y)
    for (int x = 0; x < camera.pinhole.width; ++x)
      *static_cast<float*>(image.pixeladdr(x, y)) = float(smooth_scene(ray_at(camera, region, {x, y})));
  return image;
}

}  // namespace cps
