#pragma once

#include <cstdint>

/// Which pair of a pixel sample's random numbers (SobolSample) serves which decision along its path. Two
/// decisions must never share a number: they would be correlated, and the picture biased.
///
///     pair                      x                                    y
///     joint_pair(0)             place of the camera ray in its pixel
///     joint_pair(1)             direction of the BSDF at the first surface
///     pair(7 n + …), at the n-th surface that the path meets, n = 0, 1, …:
///       pair_sun                place on the sun's disc
///       pair_sky                direction to the sky
///       pair_bsdf               direction of the BSDF, from the second surface on
///       pair_lobe               lobe of the BSDF                     whether the layer over a cached base
///                                                                    is worth a sky ray
///       pair_roulette           Russian roulette before shading      and before the next ray
///       pair_lamp               place on a lamp
///       pair_which_lamp         which lamp of the tree               which directional light
namespace cps {

enum JointPair : std::uint32_t { joint_pixel, joint_first_bsdf };

enum SurfacePair : std::uint32_t {
  pair_sun,
  pair_sky,
  pair_bsdf,
  pair_lobe,
  pair_roulette,
  pair_lamp,
  pair_which_lamp,
  pairs_per_surface
};

}  // namespace cps
