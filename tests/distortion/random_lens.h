#pragma once

#include <cmath>
#include <numbers>

#include "distortion/brown_conrady.h"
#include "distortion/pinhole.h"
#include "numbers/angles.h"
#include "random/counter_hash.h"

/// Random lenses and cameras for tests, each a pure function of stream and index.
namespace cps {

/// A camera of one of the two sizes that matter, H-FOV 30–150°.
inline Pinhole random_camera(Stream stream, std::uint64_t index) {
  const Stream s = substream(stream, 2 * index);
  const double hfov = radians(random_uniform(s, 0, 30, 150));
  return random_below(s, 1, 2) ? pinhole_from_hfov(1920, 1080, hfov) : pinhole_from_hfov(1392, 512, hfov);
}

/// A lens with the shape of real ones (corner displacement −.40 … .25, k2 and k3 in proportion, small p1, p2)
/// in units of the camera's half diagonal; some of them fold.
inline Distortion random_lens(Stream stream, std::uint64_t index, const Pinhole& camera) {
  const Stream s = substream(stream, 2 * index + 1);
  const double at_corner = random_uniform(s, 0, -0.40, 0.25);
  const double b = -0.35 + 0.35 * random_normal(s, 1), c = -0.1 * b + 0.15 * random_normal(s, 2);
  const double sum = 1 + b + c;
  const double k1 = at_corner / (std::abs(sum) < 0.25 ? std::copysign(0.25, sum) : sum);
  const double angle = random_uniform(s, 3, 0, 2 * std::numbers::pi),
               tangential = random_uniform(s, 4, 0, 0.03);
  const Distortion scaled{k1, b * k1, c * k1, tangential * std::sin(angle), tangential * std::cos(angle)};
  return rescaled(scaled, 1 / (0.5 * frame_on_plane(camera).diagonal().norm()));
}

/// A lens with coefficients of any sign, uniform in scaled units: mostly moustaches, most of them folding.
inline Distortion wild_lens(Stream stream, std::uint64_t index, const Pinhole& camera) {
  const Stream s = substream(stream, 2 * index + 1);
  const auto draw = [&](int i, double bound) { return random_uniform(s, i, -bound, bound); };
  const Distortion scaled{draw(0, 0.6), draw(1, 0.5), draw(2, 0.3), draw(3, 0.05), draw(4, 0.05)};
  return rescaled(scaled, 1 / (0.5 * frame_on_plane(camera).diagonal().norm()));
}

/// A point of the box.
inline Eigen::Vector2d random_point(Stream stream, std::uint64_t index, const Eigen::AlignedBox2d& box) {
  return {random_uniform(stream, 2 * index, box.min().x(), box.max().x()),
          random_uniform(stream, 2 * index + 1, box.min().y(), box.max().y())};
}

}  // namespace cps
