#pragma once

#include "renderer/paths/path.h"
#include "renderer/paths/surface.h"

/// Direct light at a path's vertices: shadow rays to sun, sky and lamps, and the weights that share the work
/// with the rays that meet lights by themselves (Veach 1997, multiple importance sampling).
namespace cps {

/// Pairs of random numbers that a vertex draws.
enum VertexPair : std::uint32_t {
  pair_sun,
  pair_sky,
  pair_bsdf,
  pair_lobe,
  pair_roulette,
  pair_lamp,
  pair_which_lamp,
  pairs_per_vertex
};

/// Light on its way from a lamp to a vertex, should nothing stand between.
struct ShadowRay {
  Ray ray;
  Color contribution;
  bool wanted = false;
};

/// Sky and sun where the path leaves the scene, weighed against next-event estimation at its last vertex.
Color light_from_beyond(const RenderScene& scene, const Path& path);

/// What a surface that shines adds to the path, weighed against next-event estimation at its last vertex.
Color light_from_lamp(const RenderScene& scene, const Path& path, const Hit& hit, const Surface& surface);

/// The shadow rays of a vertex, whose random numbers begin at `first_pair`.
ShadowRay towards_sun(const RenderScene& scene, const Path& path, const Surface& surface,
                      std::uint32_t first_pair);
ShadowRay towards_sky(const RenderScene& scene, const Path& path, const Surface& surface,
                      std::uint32_t first_pair);

/// Adds the light of the scene's lamps: of one of those that stand somewhere, and one of those that shine
/// from afar. Counts its rays.
void gather_lamps(const RenderScene& scene, Path& path, const Surface& surface, std::uint32_t first_pair,
                  std::uint64_t& rays);

/// Adds what the shadow rays bring; `kind` says where records note it. Rays that start and end alike are
/// `coherent`.
void gather_all(const RenderScene& scene, const ShadowRay (&shadows)[packet_size], bool coherent,
                Color VertexRecord::*kind, Path (&paths)[packet_size], std::uint64_t& rays);

}  // namespace cps
