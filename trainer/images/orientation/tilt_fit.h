#pragma once

#include "trainer/images/orientation/edge_cells.h"

namespace cps {

/// What the tilts of one family of edges say of the whole picture: a weighted least-squares fit of
/// tilt(X, Y) = c₀ + c₁ X + c₂ Y + c₃ XY + c₄ X² + c₅ Y² over the cells, with X to the right and Y down from
/// the picture's centre in units of its half diagonal, and with each cell's steep squares times its
/// coherence() as weights.
///
/// Of upright edges in a frontal plane, seen through a lens whose radial coefficient at the half diagonal is
/// K1 (TargetSpace::apparent), tilt = −2 K1 XY to first order, for both families. Roll shows in c₀, pitch in
/// the near-vertical c₁, and the tangential coefficients in c₁ and c₂.
///
/// Each coefficient has a normal prior of deviation 1/2 about zero, so that a picture without edges has
/// zeros. It is as strong as the data are weak: the number of independent tilts is taken to be (Σ weight)² /
/// Σ weight² over the cells, which a few strong edges keep small.
struct TiltFit {
  std::array<double, tilt_terms> coefficients{};  ///< of 1, X, Y, XY, X², Y²
  std::array<double, tilt_terms> errors{};        ///< their standard errors, at most 1/2
  double share = 0;     ///< of the picture's squared gradients that these edges have, 0 to 1
  double residual = 0;  ///< root mean square difference between the edges' tilts and the fit
};

/// The fit of `family` (0: near-vertical, 1: near-horizontal). Computed in doubles with operations that are
/// rounded exactly, in one order.
TiltFit fit_tilt(const EdgeCells& cells, int family);

}  // namespace cps
