#pragma once

#include "sampler/lenses/lens_options.h"

namespace cps {

/// The keys of LensBounds: calls visit(key, member, help) for each.
template <typename BoundsT, typename Visitor>
void for_each_bound_key(BoundsT& b, Visitor&& visit) {
  visit("max_displacement", b.max_displacement,
        "largest displacement of a point by a lens, as a fraction of the half diagonal; above 0, at most 1");
  visit("min_eigenvalue", b.min_eigenvalue,
        "smallest local scale of a lens, certified over its whole frame; above 0, below 1");
  visit("max_eigenvalue", b.max_eigenvalue,
        "largest local scale of a lens, certified over its whole frame; above 1");
  visit("max_tangential", b.max_tangential,
        "largest length of the vector (p1, p2) where the half diagonal is the unit of length; 0 to 1");
}

/// The recipe keys that say how lenses are drawn: calls visit(key, member, help) for each, as
/// for_each_recipe_key does for all. OptionsT is LensOptions or const LensOptions.
template <typename OptionsT, typename Visitor>
void for_each_lens_key(OptionsT& o, Visitor&& visit) {
  visit(
      "lens_draw", o.scheme,
      "how lenses are drawn: sequential, each coefficient uniform in the interval that the others leave it; "
      "shape_prior, displacement and shape such that real cameras are covered; real_lenses, as measured on "
      "photographic lenses");
  visit(
      "sequential_share", o.sequential_share,
      "share of the lenses that are drawn as sequential where lens_draw is one of the others, for coverage; "
      "0 to 1");
  visit("real_lenses_share", o.real_lenses_share,
        "share of the lenses that are drawn as real_lenses where lens_draw is shape_prior, 0 to 1; with "
        "sequential_share at most 1");
  visit("coefficients", o.coefficients.drawn,
        "coefficients to draw, separated by commas; the others are 0. Needs lens_draw = sequential");
  visit("k1_min", o.coefficients.k1_min,
        "smallest k1 to draw, as in a label (on the plane z = 1), at most 0; the bounds of the lens may cut "
        "it. Needs lens_draw = sequential");
  visit("k1_max", o.coefficients.k1_max,
        "largest k1 to draw, as in a label (on the plane z = 1), at least 0; the bounds of the lens may cut "
        "it. Needs lens_draw = sequential");
  for_each_bound_key(o.bounds, visit);
  visit("max_zoom", o.principal_point.max_zoom,
        "largest zoom of the border-free crop, at least 1; a lens that needs more is drawn again");
  visit("principal_point_x", o.principal_point.max_shift_x,
        "largest shift of cx from the image's centre, as a fraction of the width; at least 0, below 0.5");
  visit("principal_point_y", o.principal_point.max_shift_y,
        "largest shift of cy from the image's centre, as a fraction of the height; at least 0, below 0.5");
}

}  // namespace cps
