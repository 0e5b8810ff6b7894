#pragma once

#include <Eigen/Geometry>
#include <array>
#include <numeric>

#include "distortion/crop/limits.h"
#include "random/shuffle.h"
#include "sampler/lenses/lens_options.h"

namespace cps {

/// Five coefficients and the interval each was drawn from ([0, 0] if it was not), in the order k1 k2 k3 p1
/// p2.
struct SequentialDraw {
  Distortion lens;
  std::array<Interval, 5> limits;
  std::array<int, 5> order;  ///< which coefficient was drawn first, second, …
};

/// Draws the five coefficients in random order, each uniform in the interval that keeps the bounds given
/// those already drawn (the scheme of the thesis). This is one sweep of a Gibbs sampler, started at no
/// distortion, on the convex set of lenses within the bounds on `frame`, so that it never fails or rejects.
/// `choice` leaves coefficients out and cuts the interval of k1, in the frame's unit of length.
SequentialDraw draw_sequential(const Eigen::AlignedBox2d& frame, const LensBounds& bounds,
                               const CoefficientChoice& choice, Stream stream);

/// 0 … count−1 in random order.
template <std::size_t count>
std::array<int, count> drawn_order(Stream stream) {
  std::array<int, count> order;
  std::iota(order.begin(), order.end(), 0);
  shuffle(order, stream);
  return order;
}

}  // namespace cps
