#pragma once

#include "renderer/math/sobol.h"
#include "renderer/paths/render_scene.h"

namespace cps {

/// What one vertex of a path gave to its pixel: for people who look into a path.
struct VertexRecord {
  Hit hit;
  Vec3 position, normal;  ///< geometric, towards the viewer
  float footprint_m;      ///< that its textures were averaged over
  Color throughput;       ///< of the path when it arrived
  /// Contributions to the pixel.
  Color emission = Color::Zero(), sun = Color::Zero(), sky = Color::Zero(), lamps = Color::Zero();
};

struct PathRecord {
  std::vector<VertexRecord> vertices;
  Color beyond = Color::Zero();  ///< contribution of sun and sky where the path left the scene
  const char* end = "";          ///< why it ended
};

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
  PathRecord* record = nullptr;  ///< kept up to date if there is one
};

/// Which pair of the sampler each decision draws.
enum PairIndex : std::uint32_t { pair_first_vertex };
enum JointPair : std::uint32_t { joint_pixel, joint_first_direction };

/// Traces the paths that are alive to their ends: unidirectional path tracing with next-event estimation of
/// sun, sky and lamps, multiple importance sampling and Russian roulette (Kajiya 1986; Veach 1997). They
/// should start alike, since their first rays and first sun rays go as packets. Returns the number of rays.
std::uint64_t trace_paths(const RenderScene& scene, int max_shaded_vertices, Path (&paths)[packet_size]);

/// The surfaces that the paths' first rays show, and the number of rays it took: glTF hides the backs of
/// single-sided materials from the viewer.
std::uint64_t first_hits(const RenderScene& scene, const Path (&paths)[packet_size],
                         Hit (&hits)[packet_size]);

}  // namespace cps
