#pragma once

#include "renderer/math/sobol.h"
#include "renderer/paths/random_pairs.h"
#include "renderer/paths/render_scene.h"

namespace cps {

/// What one vertex of a path gave to its pixel, for inspecting paths.
struct VertexRecord {
  Hit hit;
  Vec3 position, normal;  ///< geometric, towards the viewer
  float footprint_m;      ///< width that its textures were averaged over
  Color throughput;       ///< of the path when it arrived
  /// Contributions to the pixel.
  Color emission = Color::Zero(), sun = Color::Zero(), sky = Color::Zero(), lamps = Color::Zero(),
        cached = Color::Zero();
};

struct PathRecord {
  std::vector<VertexRecord> vertices;
  Color beyond = Color::Zero();  ///< contribution of sun and sky where the path left the scene
  const char* end = "";          ///< why it ended
};

/// One path from the camera: its current state, and what it has gathered.
struct Path {
  Ray ray;
  SobolSample random;
  float cone_width = 0;   ///< metres that a pixel's cone spans at the ray's origin
  float cone_spread = 0;  ///< its opening angle, rad
  float pdf = std::numeric_limits<float>::infinity();  ///< density of the ray's direction, 1/sr; infinite:
                                                       ///< not drawn at random
  float min_roughness = 0;                             ///< lower limit on later surfaces
  Vec3 vertex_position, vertex_normal;                 ///< of the surface that drew it, if pdf is finite
  int met_surfaces = 0;                                ///< including glass that it passed straight through
  int shaded_vertices = 0;                             ///< surface points that scattered it
  bool skips_sun_and_lamps = false;  ///< its ray leaves out the sun and the lamps that light samples draw
  Color throughput = Color::Ones();
  Color radiance = Color::Zero();  ///< the result
  std::uint32_t rays = 0;          ///< traced for it so far, shadow rays included
  bool alive = false;
  PathRecord* record = nullptr;  ///< kept up to date if not null

  /// Random numbers for a decision at the surface that it is meeting, uniform in [0, 1)².
  Eigen::Vector2f pair(SurfacePair which) const {
    return random.pair(pairs_per_surface * static_cast<std::uint32_t>(met_surfaces) + which);
  }
};

/// Ray::id of the first ray of a path with these random numbers.
inline std::uint32_t first_ray_id(const SobolSample& random) {
  return static_cast<std::uint32_t>(mix64(random.pixel_key + random.index));
}

/// Traces the paths that are alive to their ends: unidirectional path tracing with next-event estimation of
/// sun, sky and lamps, multiple importance sampling and Russian roulette (Kajiya 1986; Veach 1997). The
/// first rays and the first sun rays are traced as packets: fastest if the paths start alike.
void trace_paths(const RenderScene& scene, int max_shaded_vertices, Path (&paths)[packet_size]);

/// The surfaces that the first rays of the living paths show. glTF hides the backs of single-sided materials
/// from the viewer.
void first_hits(const RenderScene& scene, Path (&paths)[packet_size], Hit (&hits)[packet_size]);

}  // namespace cps
