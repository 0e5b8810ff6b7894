#include <catch2/catch.hpp>
#include <cmath>

#include "sampler/lenses/real_lens_prior.h"
#include "tests/sampler/lenses/kolmogorov.h"

using namespace cps;

TEST_CASE("drawn real lenses have the fitted quantiles and spread, at a fitted H-FOV and between two") {
  for (double hfov_deg : {70.0, 74.0}) {
    const RealLensFit fit = real_lens_fit_at(hfov_deg);
    constexpr int count = 20000;
    int below[7] = {};
    std::vector<double> k2_rest, k3_rest;
    for (int i = 0; i < count; ++i) {
      const Distortion lens =
          draw_real_lens(hfov_deg * M_PI / 180, substream(make_stream(1, "real lens"), i));
      const double corner = lens.k1 + lens.k2 + lens.k3;
      for (int q = 0; q < 7; ++q) below[q] += corner < fit.corner[q] - 1e-12;
      k2_rest.push_back((lens.k2 - fit.k2_slope * corner) / fit.k2_sd);
      k3_rest.push_back((lens.k3 - fit.k3_slope * corner - fit.k3_on_k2 * fit.k2_sd * k2_rest.back()) /
                        fit.k3_sd);
    }
    CHECK(below[0] == 0);
    CHECK(below[6] <= count);
    for (int q = 1; q < 6; ++q) {
      const double p = corner_probabilities[q];
      CHECK(std::abs(below[q] - p * count) < 3.3 * std::sqrt(count * p * (1 - p)));  // p = .001
    }
    CHECK(kolmogorov(k2_rest, normal_cdf) < one_in_a_thousand);
    CHECK(kolmogorov(k3_rest, normal_cdf) < one_in_a_thousand);
  }
}

TEST_CASE("fits are linear between H-FOVs, and constant outside those that were measured") {
  const RealLensFit a = real_lens_fit_at(60), b = real_lens_fit_at(70), middle = real_lens_fit_at(65);
  CHECK(middle.corner[1] == Approx(0.5 * (a.corner[1] + b.corner[1])));
  CHECK(middle.k3_sd == Approx(0.5 * (a.k3_sd + b.k3_sd)));
  CHECK(real_lens_fit_at(150).corner == real_lens_fit_at(100).corner);
  CHECK(real_lens_fit_at(3).k2_sd == real_lens_fit_at(10).k2_sd);
}
