#include "sampler/shape_prior.h"

#include <cmath>
#include <numbers>

namespace cps {
namespace {

enum Drawn : std::uint64_t { corner_displacement, ratio_b, ratio_c, tangential_angle, tangential_length };

constexpr double least_sum = 0.25;

}  // namespace

LensShape draw_shape(Stream stream) {
  const double b = -0.35 + 0.35 * random_normal(stream, ratio_b);
  return {.corner = random_uniform(stream, corner_displacement, -0.33, 0.20),
          .b = b,
          .c = -0.1 * b + 0.15 * random_normal(stream, ratio_c)};
}

std::optional<Distortion> radial_lens(const LensShape& shape) {
  const double sum = 1 + shape.b + shape.c;
  if (std::abs(sum) < least_sum) return std::nullopt;
  const double k1 = shape.corner / sum;
  return Distortion{.k1 = k1, .k2 = shape.b * k1, .k3 = shape.c * k1};
}

std::optional<Distortion> draw_from_shape_prior(double max_tangential, Stream stream) {
  std::optional<Distortion> lens = radial_lens(draw_shape(stream));
  if (!lens) return lens;
  const double angle = random_uniform(stream, tangential_angle, 0, 2 * std::numbers::pi);
  const double length = random_uniform(stream, tangential_length, 0, max_tangential);
  lens->p1 = length * std::sin(angle);
  lens->p2 = length * std::cos(angle);
  return lens;
}

}  // namespace cps
