#include <catch2/catch.hpp>
#include <map>

#include "scenes/city/roadside/pavement_tracks.h"
#include "scenes/city/roadside/roadside.h"
#include "scenes/city/roadside/surroundings.h"
#include "scenes/city/streets/driving_lanes.h"
#include "scenes/city/streets/street_grid.h"
#include "tests/scenes/city/all_styles.h"

using namespace cps;
using namespace cps::city;

namespace {

constexpr int seeds = 6, seeds_per_style = 2;

/// Where things stand does not depend on materials and models, so all seeds share one set.
struct Catalogue {
  GlbWriter writer;
  Materials materials = make_materials(writer, 0);
  ModelLibrary models = make_models(writer, materials, 0);
};

const Catalogue& catalogue() {
  static const Catalogue shared;
  return shared;
}

/// The plan of a city, without meshes.
struct City {
  CityOptions options;
  StreetNetwork network = draw_street_network(options);
  Districts districts = draw_districts(options);

  const CityCharacter& character(int block) const {
    return districts.character_at(block_middle(network, block));
  }
  BlockPlan plan(int block) const { return plan_block(network, block, character(block), options.seed); }
  std::vector<PlacedModel> furniture(int block, const BlockPlan& plan) const {
    return furnish(network, block, plan, catalogue().models, character(block), options);
  }
};

double distance(const Polyline& lane, const Polygon& ground) {
  double nearest = 1e9;
  for (const Vec2& p : ground) nearest = std::min(nearest, distance_to_line(lane, p));
  for (double s = 0; s < length(lane); s += 0.5)
    nearest = std::min(nearest, distance_to_polygon(ground, station_at(lane, s).point));
  return nearest;
}

bool is_near(const Polyline& lane, const Polygon& ground) {
  return distance_to_line(lane, ground[0]) < 15;
}

}  // namespace

TEST_CASE("in every style, lanes are free of parked cars, trees, poles and buildings") {
  for (const CityStyle style : all_styles)
    for (std::uint64_t seed = 0; seed < seeds_per_style; ++seed) {
      INFO(to_string(style) << " " << seed);
      const City city{{.seed = seed, .style = style, .extent_m = 300}};
      const std::vector<DrivingLane> all = driving_lanes(city.network);
      int cars = 0, others = 0;
      for (int b = 0; b < static_cast<int>(city.network.blocks.size()); ++b) {
        const BlockPlan plan = city.plan(b);
        for (const PlacedModel& placed : city.furniture(b, plan)) {
          const bool is_car = placed.model->kind == ModelKind::car;
          ++(is_car ? cars : others);
          const Polygon ground = placed.footprint();
          for (const DrivingLane& lane : all)
            if (is_near(lane.points, ground)) {
              const double room = distance(lane.points, ground) - lane.width_m / 2;
              if (room < (is_car ? 0.0 : 0.2))
                FAIL_CHECK(placed.model->name << " " << room << " m from a lane");
            }
        }
        for (const BuildingPlan& house : plan.buildings)
          for (const DrivingLane& lane : all)
            if (is_near(lane.points, house.footprint.polygon()))
              CHECK(distance(lane.points, house.footprint.polygon()) > lane.width_m / 2 + 1);
      }
      CHECK(cars > 20);
      CHECK(others > 200);
    }
}

TEST_CASE("no tree crown reaches over a lane") {
  int trees = 0;
  for (const CityStyle style : all_styles)
    for (std::uint64_t seed = 0; seed < seeds_per_style; ++seed) {
      INFO(to_string(style) << " " << seed);
      const City city{{.seed = seed, .style = style, .extent_m = 300}};
      const std::vector<DrivingLane> all = driving_lanes(city.network);
      for (int b = 0; b < static_cast<int>(city.network.blocks.size()); ++b)
        for (const PlacedModel& placed : city.furniture(b, city.plan(b))) {
          if (placed.model->kind != ModelKind::tree) continue;
          ++trees;
          const double crown_m = placed.model->crown_radius * placed.scale;
          for (const DrivingLane& lane : all)
            if (lane.junction < 0)
              if (const double over_m =
                      crown_m + lane.width_m / 2 - distance_to_line(lane.points, placed.position);
                  over_m > 0.45)
                FAIL_CHECK(placed.model->name << " hangs " << over_m << " m over a lane");
        }
    }
  CHECK(trees > 1000);
}

TEST_CASE("in every style, buildings, pads and models do not overlap") {
  for (const CityStyle style : all_styles)
    for (std::uint64_t seed = 0; seed < seeds_per_style; ++seed) {
      INFO(to_string(style) << " " << seed);
      const City city{{.seed = seed, .style = style, .extent_m = 300}};
      for (int b = 0; b < static_cast<int>(city.network.blocks.size()); ++b) {
        const BlockPlan plan = city.plan(b);
        std::vector<Polygon> taken;
        for (const BuildingPlan& house : plan.buildings) {
          taken.push_back(house.footprint.polygon());
          if (const Polygon wing = rear_wing(house); !wing.empty()) taken.push_back(wing);
        }
        const std::size_t built = taken.size();
        for (const Pad& pad : plan.pads) taken.push_back(pad.outline);
        for (std::size_t i = 0; i < taken.size(); ++i)
          for (std::size_t j = 0; j < i; ++j)
            if (overlap(taken[i], taken[j], 0.05))
              FAIL_CHECK("block " << b << ": houses or pads " << i << " and " << j);
        taken.resize(built);
        for (const Polygon& house : taken)
          for (const Vec2& corner : house) CHECK(distance_to_polygon(plan.border.points, corner) < 0.06);
        const std::vector<PlacedModel> placed = city.furniture(b, plan);
        for (std::size_t i = 0; i < placed.size(); ++i) {
          for (std::size_t j = 0; j < i; ++j)
            if ((placed[i].position - placed[j].position).norm() < 8 &&
                overlap(placed[i].footprint(), placed[j].footprint(), 0.01))
              FAIL_CHECK(placed[i].model->name << " in " << placed[j].model->name);
          for (const Polygon& house : taken)
            if (overlap(placed[i].footprint(), house, 0.01))
              FAIL_CHECK(placed[i].model->name << " in a house");
        }
      }
    }
}

TEST_CASE("cycle tracks on pavements leave room for pedestrians and hold only cyclists") {
  int tracks = 0, riders = 0;
  for (const CityStyle style : {CityStyle::european, CityStyle::downtown})
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      INFO(to_string(style) << " " << seed);
      const City city{{.seed = seed, .style = style, .extent_m = 400}};
      for (int b = 0; b < static_cast<int>(city.network.blocks.size()); ++b) {
        const BlockPlan plan = city.plan(b);
        const std::vector<PlacedModel> placed = city.furniture(b, plan);
        const std::vector<Side>& sides = city.network.blocks[b].sides;
        for (std::size_t i = 0; i < sides.size(); ++i) {
          if (!city.network.is_road(sides[i])) continue;
          const KerbSide kerb = kerb_side(city.network, sides[i], plan.pavement_m[i], city.options);
          const Polyline track = pavement_track(city.network, kerb);
          if (track.empty()) continue;
          ++tracks;
          const double half = city.network.profile(sides[i]).pavement_cycle_m / 2;
          CHECK(pavement_track_inset_m + 2 * half + 0.9 < plan.pavement_m[i]);
          for (const PlacedModel& p : placed) {
            if (distance(track, p.footprint()) > half - 0.03) continue;
            CHECK(p.model->name == "cyclist");
            ++riders;
          }
        }
      }
    }
  CHECK(tracks > 30);
  CHECK(riders > 30);
}

TEST_CASE("each style has mostly the kinds of blocks it is named for") {
  const auto shares = [](CityStyle style) {
    std::map<BlockKind, double> shares;
    int blocks = 0;
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const City city{{.seed = seed, .style = style, .extent_m = 300}};
      for (int b = 0; b < static_cast<int>(city.network.blocks.size()); ++b, ++blocks)
        ++shares[city.plan(b).kind];
    }
    for (auto& [kind, share] : shares) share /= blocks;
    return shares;
  };
  CHECK(shares(CityStyle::european)[BlockKind::closed] > 0.35);
  CHECK(shares(CityStyle::downtown)[BlockKind::towers] > 0.5);
  CHECK(shares(CityStyle::suburb)[BlockKind::detached] > 0.7);
  CHECK(shares(CityStyle::industrial)[BlockKind::halls] > 0.7);
  std::map<BlockKind, double> mixed = shares(CityStyle::mixed);
  for (const BlockKind kind : {BlockKind::closed, BlockKind::towers, BlockKind::detached, BlockKind::halls})
    CHECK(mixed[kind] > 0.08);
}

TEST_CASE("shared ends of houses are blank walls, free ends have windows") {
  int shared = 0, open = 0;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const StreetNetwork network = draw_street_network({.seed = seed});
    for (int b = 0; b < static_cast<int>(network.blocks.size()); ++b) {
      const BlockPlan plan = plan_block(network, b, draw_character(seed), seed);
      for (const BuildingPlan& house : plan.buildings)
        for (const bool at_end : {false, true}) {
          const bool blank = at_end ? house.party_end : house.party_start;
          const Footprint& f = house.footprint;
          const std::size_t i = at_end ? f.front.size() - 1 : 0;
          double nearest = 1e9;  // distance from the middle of this end to another house
          for (const BuildingPlan& other : plan.buildings)
            if (&other != &house)
              nearest =
                  std::min(nearest, distance_to_polygon(other.footprint.polygon(), f.at(i, f.depth_m / 2)));
          if (plan.kind == BlockKind::closed && nearest < 0.01) CHECK(blank);
          if (nearest > 0.35) CHECK_FALSE(blank);
          ++(blank ? shared : open);
        }
    }
  }
  CHECK(shared > 100);
  CHECK(open > 100);
}

TEST_CASE("the surroundings stay outside the built area and reach to the horizon") {
  const CityOptions options{.seed = 4};
  const StreetNetwork network = draw_street_network(options);
  const Surroundings around = surroundings(network, catalogue().materials, catalogue().models, options);
  CHECK(around.models.size() > 100);
  for (const PlacedModel& placed : around.models)
    for (const Vec2& p : placed.footprint()) CHECK_FALSE(contains(network.rim, p));
  double reach = 0;
  for (const auto& [material, surface] : around.terrain.surfaces)
    for (const Eigen::Vector3f& p : surface.positions) {
      reach = std::max<double>(reach, p.norm());
      if (contains(network.rim, Vec2(p.x(), -p.z()))) CHECK(p.y() < -0.1f);
    }
  CHECK(reach > 5000);
}

TEST_CASE("tree density and parked cars follow the options") {
  const StreetNetwork network = draw_street_network({.seed = 5});
  const CityCharacter character = draw_character(5);
  const auto count = [&](const CityOptions& options, ModelKind kind) {
    int n = 0;
    for (int b = 0; b < static_cast<int>(network.blocks.size()); ++b)
      for (const PlacedModel& p :
           furnish(network, b, plan_block(network, b, character, 5), catalogue().models, character, options))
        n += p.model->kind == kind;
    return n;
  };
  CHECK(count({.seed = 5, .tree_density = 0}, ModelKind::tree) == 0);
  CHECK(count({.seed = 5, .parked_cars = 0}, ModelKind::car) == 0);
  const int trees = count({.seed = 5}, ModelKind::tree), cars = count({.seed = 5}, ModelKind::car);
  CHECK(count({.seed = 5, .tree_density = 0.5}, ModelKind::tree) < 0.7 * trees);
  CHECK(count({.seed = 5, .parked_cars = 0.5}, ModelKind::car) < 0.7 * cars);
  CHECK(count({.seed = 5, .parked_cars = 2}, ModelKind::car) > 1.1 * cars);
  // Changing one thing does not change another.
  CHECK(count({.seed = 5, .tree_density = 0}, ModelKind::car) == count({.seed = 5}, ModelKind::car));
}
