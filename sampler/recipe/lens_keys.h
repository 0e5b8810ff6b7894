#pragma once

#include "sampler/lenses/lens_options.h"

namespace cps {

/// Those of LensBounds.
template <typename BoundsT, typename Visitor>
void for_each_bound_key(BoundsT& b, Visitor&& visit) {
  visit("max_displacement", b.max_displacement, "farthest a lens moves a point, of the half diagonal");
  visit("min_eigenvalue", b.min_eigenvalue, "least local scale of a lens (certified)");
  visit("max_eigenvalue", b.max_eigenvalue, "largest local scale of a lens (certified)");
  visit("max_tangential", b.max_tangential, "|(p1, p2)| in units of the half diagonal");
}

/// The recipe keys that say how lenses are drawn: calls visit(key, member, help) for each, as
/// for_each_recipe_key does for all. OptionsT is LensOptions or const LensOptions.
template <typename OptionsT, typename Visitor>
void for_each_lens_key(OptionsT& o, Visitor&& visit) {
  visit("lens_draw", o.scheme, "sequential, or from a prior: shape_prior or real_lenses");
  visit("sequential_share", o.sequential_share, "share of sequential draws among the lenses of a prior");
  visit("coefficients", o.coefficients.drawn, "those drawn, the others are 0 (sequential only)");
  visit("k1_min", o.coefficients.k1_min, "least k1 on the plane z = 1, where the bounds allow it");
  visit("k1_max", o.coefficients.k1_max, "most");
  for_each_bound_key(o.bounds, visit);
  visit("max_zoom", o.principal_point.max_zoom, "largest zoom of the crop");
  visit("principal_point_x", o.principal_point.max_shift_x, "largest shift of cx, of the width");
  visit("principal_point_y", o.principal_point.max_shift_y, "largest shift of cy, of the height");
}

}  // namespace cps
