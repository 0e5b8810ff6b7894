#include "sampler/lenses/shape_prior.h"

#include <cmath>

namespace cps {
namespace {

enum ShapeNumber : std::uint64_t { corner_displacement, ratio_b, ratio_c };

constexpr double min_sum = 0.25;

}  // namespace

LensShape draw_shape(Stream stream) {
  const double b = -0.35 + 0.35 * random_normal(stream, ratio_b);
  return {.corner = random_uniform(stream, corner_displacement, -0.33, 0.20),
          .b = b,
          .c = -0.1 * b + 0.15 * random_normal(stream, ratio_c)};
}

std::optional<Distortion> radial_lens(const LensShape& shape) {
  const double sum = 1 + shape.b + shape.c;
  if (std::abs(sum) < min_sum) return std::nullopt;
  const double k1 = shape.corner / sum;
  return Distortion{.k1 = k1, .k2 = shape.b * k1, .k3 = shape.c * k1};
}

}  // namespace cps
