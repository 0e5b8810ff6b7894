#include <algorithm>
#include <catch2/catch.hpp>

#include "dataset/report/frame_distributions.h"

using namespace cps;

TEST_CASE("the limits of full well and read noise are those of an image pixel as frames.csv has them") {
  for (const int binning : {1, 4}) {
    INFO("binning " << binning);
    Recipe recipe;
    recipe.sensor.binning = binning;
    const std::vector<Distribution> all = frame_distributions(recipe);
    const auto limits_of = [&](const std::string& name) {
      const auto found = std::ranges::find(all, name, &Distribution::name);
      REQUIRE(found != all.end());
      REQUIRE(found->limits);
      return *found->limits;
    };
    const Interval full_well = limits_of("full well"), read_noise = limits_of("read noise");
    CHECK(full_well == Interval{2000.0 * binning * binning, 12000.0 * binning * binning});
    CHECK(read_noise == Interval{2.0 * binning, 8.0 * binning});
    for (int i = 0; i < 200; ++i) {
      const SensorSettings drawn = draw_sensor(recipe.sensor, substream(make_stream(1, "report"), i));
      CHECK((drawn.full_well_e > 0.999 * full_well.low && drawn.full_well_e < 1.001 * full_well.high));
      CHECK((drawn.read_noise_e >= read_noise.low && drawn.read_noise_e <= read_noise.high));
    }
  }
}
