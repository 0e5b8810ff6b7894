#include "sampler/lenses/sequential_draw.h"

#include <algorithm>

namespace cps {

SequentialDraw draw_sequential(const Eigen::AlignedBox2d& frame, const LensBounds& bounds,
                               const CoefficientChoice& choice, Stream stream) {
  SequentialDraw drawn;
  drawn.order = drawn_order<5>(make_stream(stream.key, "coefficient order"));
  const Stream values = make_stream(stream.key, "coefficients");
  for (int which : drawn.order) {
    const Coefficient name = all_coefficients[which];
    if (std::find(choice.drawn.begin(), choice.drawn.end(), name) == choice.drawn.end()) continue;
    Interval limits = coefficient_limits(drawn.lens, name, frame, bounds);
    if (name == Coefficient::k1)
      limits = {std::max(limits.low, choice.k1_min), std::min(limits.high, choice.k1_max)};
    coefficient(drawn.lens, name) = random_uniform(values, which, limits.low, limits.high);
    drawn.limits[which] = limits;
  }
  return drawn;
}

}  // namespace cps
