#pragma once

#include <OpenImageIO/imagebuf.h>

#include "distortion/warp/render_noise.h"
#include "renderer/render.h"
#include "sampler/lenses/lens_draw.h"
#include "sensor/develop.h"

/// The way of an image as `cps generate` takes it, without its plan and files.
namespace cps {

/// The undistorted, linear, oversampled render that lenses of `base` share, and its exposure.
struct Master {
  Pinhole camera;
  NoisyMaster noisy;
  double exposure = 1;
};

/// `samples` of each half.
inline Master render_master(const RenderScene& scene, const Eigen::Isometry3d& world_from_camera,
                            const Pinhole& camera, RenderOptions options) {
  const Camera view{.world_from_camera = world_from_camera, .pinhole = camera};
  const OIIO::ImageBuf first = render(scene, view, options);
  options.seed = make_stream(options.seed, "second half").key;
  NoisyMaster noisy = join_halves(first, render(scene, view, options));
  const double exposure = meter_exposure(noisy.picture);
  return {.camera = camera, .noisy = std::move(noisy), .exposure = exposure};
}

/// 8-bit RGB: the master through the lens and a sensor drawn from `stream`.
inline OIIO::ImageBuf photograph(const Master& master, const Pinhole& base, const DrawnLens& lens,
                                 const SensorOptions& sensor, Stream stream) {
  const SensorSettings settings = draw_sensor(sensor, make_stream(stream.key, "settings"));
  return develop(
      warp(master.noisy, master.camera, lens.distortion, lens.crop.camera, {.box = frame_on_plane(base)}),
      master.exposure, settings, make_stream(stream.key, "noise"));
}

}  // namespace cps
