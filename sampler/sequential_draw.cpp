#include "sampler/sequential_draw.h"

namespace cps {

SequentialDraw draw_sequential(const Eigen::AlignedBox2d& frame, const LensBounds& bounds, Stream stream) {
  constexpr Coefficient coefficients[] = {Coefficient::k1, Coefficient::k2, Coefficient::k3, Coefficient::p1,
                                          Coefficient::p2};
  SequentialDraw drawn;
  drawn.order = drawn_order<5>(make_stream(stream.key, "coefficient order"));
  const Stream values = make_stream(stream.key, "coefficients");
  for (int which : drawn.order) {
    const Interval limits = coefficient_limits(drawn.lens, coefficients[which], frame, bounds);
    coefficient(drawn.lens, coefficients[which]) = random_uniform(values, which, limits.low, limits.high);
    drawn.limits[which] = limits;
  }
  return drawn;
}

}  // namespace cps
