#include "renderer/camera_path.h"

#include <algorithm>
#include <cmath>

#include "renderer/cache/light_cache.h"
#include "renderer/paths/path_steps.h"

namespace cps {
namespace {

Path path_along(const PathSource& source, const CameraPixel& pixel, const SobolSample& random,
                const Eigen::Vector2f& offset_px) {
  const CameraRay ray = camera_ray(source.rays, pixel, offset_px);
  Path path;
  path.random = random;
  path.ray.origin = source.rays.position;
  path.ray.direction = ray.direction;
  path.ray.id = first_ray_id(random);
  path.ray.from_viewer = true;
  path.cone_spread = source.footprint * ray.pixel_angle;
  path.alive = ray.is_seen;
  return path;
}

}  // namespace

PathSource make_path_source(const Camera& camera, const RenderOptions& options) {
  // Many samples average over the pixel by themselves: finer texture lookups then keep surfaces sharp that
  // are seen at a slant (as pbrt scales its ray differentials).
  const float footprint = std::max(0.125f, 1.0f / std::sqrt(static_cast<float>(options.samples)));
  return {make_camera_rays(camera, options.filter), options.filter, options.seed, footprint};
}

Path camera_path(const PathSource& source, const CameraPixel& pixel, int x, int y, int index) {
  const SobolSample random = make_sobol_sample(source.seed, x, y, static_cast<std::uint32_t>(index));
  return path_along(source, pixel, random, sample_filter(source.filter, random.joint_pair(joint_pixel)));
}

Path central_path(const PathSource& source, const CameraPixel& pixel, int x, int y) {
  return path_along(source, pixel, make_sobol_sample(source.seed, x, y, 0), central_offset_px);
}

void trace_packet(const RenderScene& scene, const RenderOptions& options, Path (&paths)[packet_size]) {
  if (options.cache)
    trace_paths_with(scene, true, paths,
                     [&](Path& path, const Hit& hit) { return options.cache->shade(path, hit); });
  else
    trace_paths(scene, options.max_shaded_vertices, paths);
}

}  // namespace cps
