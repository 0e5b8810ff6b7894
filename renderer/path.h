#pragma once

#include "renderer/render_scene.h"
#include "renderer/sobol.h"

namespace cps {

/// One path from the camera: where it stands, and what it has gathered.
struct Path {
  Ray ray;
  Sampler sampler;
  float cone_width = 0;   ///< metres that a pixel's cone spans at the ray's origin
  float cone_spread = 0;  ///< its opening angle, rad
  float pdf = std::numeric_limits<float>::infinity();  ///< with which the ray's direction was drawn;
                                                       ///< infinite: no choice
  float least_roughness = 0;                           ///< of the surfaces to come
  Vec3 vertex_position, vertex_normal;                 ///< of the surface that drew it, if pdf is finite
  int shaded_vertices = 0;                             ///< surface points behind it
  Color throughput = Color::Ones();
  Color radiance = Color::Zero();  ///< the answer
  bool alive = false;
};

/// Which pair of the sampler each decision draws.
enum PairIndex : std::uint32_t { pair_pixel, pair_first_vertex };

/// Traces the paths that are alive to their ends: unidirectional path tracing with next-event estimation of
/// sun, sky and lamps, multiple importance sampling and Russian roulette (Kajiya 1986; Veach 1997). They
/// should start alike, since their first rays and first sun rays go as packets. Returns the number of rays.
std::uint64_t trace_paths(const RenderScene& scene, int max_shaded_vertices, Path (&paths)[packet_size]);

}  // namespace cps
