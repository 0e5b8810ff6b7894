#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "sampler/lenses/model_prior.h"

using namespace cps;

TEST_CASE("parameters of every family are uniform in an interval, usable, and a function of the stream") {
  const Stream stream = make_stream(8, "model prior");
  constexpr int draws = 4000;
  for (const std::string_view family : prior_families()) {
    std::map<std::string_view, double> lowest, highest, sum;
    for (int i = 0; i < draws; ++i) {
      const LensModel lens = draw_model_lens(family, substream(stream, i));
      REQUIRE(fault(lens) == "");
      REQUIRE(family_name(lens) == family);
      for (const auto& [name, value] : parameters(lens)) {
        if (i == 0) lowest[name] = highest[name] = value;
        lowest[name] = std::min(lowest[name], value);
        highest[name] = std::max(highest[name], value);
        sum[name] += value / draws;
      }
    }
    CHECK(draw_model_lens(family, substream(stream, 7)) == draw_model_lens(family, substream(stream, 7)));
    for (const auto& [name, mean] : sum) {
      const double width = highest[name] - lowest[name];
      // The mean of a uniform has the deviation width/√(12 draws): five of them.
      CHECK(std::abs(mean - (lowest[name] + highest[name]) / 2) <=
            width * (5 / std::sqrt(12.0 * draws) + 2.0 / draws));
    }
  }
  // DeepCalib's range of ξ.
  double largest = 0;
  for (int i = 0; i < draws; ++i)
    largest = std::max(
        largest, std::get<UnifiedSpherical>(draw_model_lens("unified_spherical", substream(stream, i))).xi);
  CHECK(largest == Approx(1.2).margin(.01));
}

TEST_CASE("a family without a prior is refused, with those that have one") {
  CHECK_THROWS_WITH(draw_model_lens("rational", make_stream(0, "")),
                    Catch::Contains("rational") && Catch::Contains("kannala_brandt"));
}
