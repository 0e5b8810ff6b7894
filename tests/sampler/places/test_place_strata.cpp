#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>
#include <set>

#include "sampler/places/place_draw.h"
#include "tests/sampler/lenses/kolmogorov.h"
#include "tests/sampler/plain_scene.h"

using namespace cps;

namespace {

Recipe straight_recipe() {
  Recipe recipe;
  recipe.split = "thesis";
  recipe.lateral_m = recipe.heading_deg = recipe.lane_change_share = 0;
  return recipe;
}

/// Position of a place along all usable lanes, 0 … 1.
double share_along(const DrivableScene& scene, const Place& place) {
  double before = 0, total = 0, at = -1;
  for (const Route& route : scene.routes)
    for (int lane : route.lanes) {
      const Eigen::Vector3d from = scene.lanes[lane].points[0].cast<double>(),
                            along = scene.lanes[lane].points[1].cast<double>() - from;
      const double s = (place.position - from).dot(along.normalized());
      if (std::abs(place.position.z() - from.z()) < 0.1) at = before + s - scene.usable[lane].from_m;
      before += scene.usable[lane].length_m();
      total = before;
    }
  REQUIRE(at > -1e-3);
  return at / total;
}

struct Gaps {
  double largest = 0, nearest = 0;  ///< the latter on average, both times the number of places
};

Gaps gaps_of(std::vector<double> places) {
  std::sort(places.begin(), places.end());
  const double n = static_cast<double>(places.size());
  Gaps gaps;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double before = i > 0 ? places[i] - places[i - 1] : places[i],
                 after = i + 1 < places.size() ? places[i + 1] - places[i] : 1 - places[i];
    gaps.largest = std::max({gaps.largest, n * before, n * after});
    gaps.nearest += std::min(before, after);
  }
  return gaps;
}

}  // namespace

TEST_CASE("every stratum is dealt once, in an order that the seed decides") {
  const auto strata = deal_strata(100, make_stream(1, "strata")),
             other = deal_strata(100, make_stream(2, "strata"));
  std::set<std::int64_t> dealt;
  int same = 0, in_order = 0;
  for (std::size_t i = 0; i < strata.size(); ++i) {
    CHECK(strata[i].count == 100);
    dealt.insert(strata[i].index);
    same += strata[i].index == other[i].index;
    in_order += i > 0 && strata[i].index == strata[i - 1].index + 1;
  }
  CHECK(dealt.size() == 100);
  CHECK(*dealt.begin() == 0);
  CHECK(same < 10);
  CHECK(in_order < 10);
}

TEST_CASE("a place is first tried in its stratum, then around it, and at last anywhere") {
  for (const LaneStratum stratum :
       {LaneStratum{0, 1}, LaneStratum{0, 7}, LaneStratum{3, 7}, LaneStratum{999'999, 1'000'000}}) {
    double width = 0;
    for (int attempt = 0; attempt < 200; ++attempt) {
      const double low = stratified(stratum, attempt, 0), high = stratified(stratum, attempt, 1);
      const double n = static_cast<double>(stratum.count);
      CHECK(low >= 0);
      CHECK(high <= 1 + 1e-12);
      CHECK(low <= stratum.index / n + 1e-12);  // the stratum is part of it
      CHECK(high >= (stratum.index + 1) / n - 1e-12);
      if (attempt < 20) CHECK(high - low == Approx(1 / n));
      CHECK(high - low >= width - 1e-12);
      width = high - low;
    }
    CHECK(width == Approx(1));
  }
}

TEST_CASE("places share the lanes out: none far from all others, few close together, as many everywhere") {
  const Recipe recipe = straight_recipe();
  const DrivableScene scene = drivable_scene(plain_scene(8), "plain", recipe, make_stream(1, "streets"));
  constexpr int places = 150;
  std::vector<double> first_places;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    std::vector<double> dealt, independent;
    const auto strata = deal_strata(places, make_stream(seed, "strata"));
    for (int i = 0; i < places; ++i) {
      const Stream stream = substream(make_stream(seed, "place"), i);
      const auto at = [&](const LaneStratum& stratum) {
        return share_along(scene, draw_place(scene, Rig{}, Part::all, recipe, stratum, stream).place);
      };
      dealt.push_back(at(strata[i]));
      if (seed < 4) independent.push_back(at({}));
    }
    first_places.push_back(dealt[0]);
    const Gaps shared = gaps_of(dealt);
    CHECK(shared.largest < 2.001);  // two neighbours drawn at the far ends of their strata
    if (seed >= 4) continue;
    const Gaps alone = gaps_of(independent);
    CHECK(alone.largest > 3);
    CHECK(shared.nearest > 1.1 * alone.nearest);
  }
  // And one place among them is as likely anywhere.
  CHECK(kolmogorov(first_places, [](double x) { return uniform_cdf(x, 0, 1); }) < one_in_a_thousand);
}

TEST_CASE("where a whole stratum is taken, its place is found beside it") {
  const Recipe recipe = straight_recipe();
  Scene scene = plain_scene(3);
  scene.lanes[2].occupied = {{0, 300}};
  const DrivableScene drivable = drivable_scene(scene, "plain", recipe, make_stream(1, "streets"));
  for (int i = 0; i < 6; ++i) {  // six lanes, a stratum each
    const DrawnPlace drawn =
        draw_place(drivable, Rig{}, Part::all, recipe, {i, 6}, substream(make_stream(3, "place"), i));
    const double at = 6 * share_along(drivable, drawn.place);
    if (i == 2)
      CHECK((at < 2 || at > 3));
    else
      CHECK((at >= i && at <= i + 1));
  }
}
