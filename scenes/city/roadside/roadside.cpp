#include "scenes/city/roadside/roadside.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/city/roadside/boundary.h"
#include "scenes/city/roadside/tree.h"
#include "scenes/city/roadside/vehicle.h"
#include "scenes/city/streets/road_markings.h"
#include "scenes/city/streets/road_surface.h"

namespace cps::city {
namespace {

double angle_of(const Vec2& direction) {
  return std::atan2(direction.y(), direction.x());
}

enum Species { lime, maple, plane, hornbeam, young, shrub, spruce };

class Furnisher {
 public:
  Furnisher(const StreetNetwork& network, const BlockPlan& plan, const ModelLibrary& models,
            const CityOptions& options, const CityCharacter& character, Stream stream)
      : network(network),
        plan(plan),
        models(models),
        options(options),
        character(character),
        stream(stream) {}

  std::vector<PlacedModel> placed;

  void furnish_side(const Side& side, double pavement_m, std::uint64_t seed) {
    const Segment& segment = network.segments[side.segment];
    const Street& street = network.streets[segment.street];
    const Approach first = approach(network, side.segment, side.reversed, seed);
    const Approach last = approach(network, side.segment, !side.reversed, seed);
    const Polyline centre = network.line(side, 0);
    const double cut_first = side.reversed ? segment.cut_to : segment.cut_from;
    const double cut_last = side.reversed ? segment.cut_from : segment.cut_to;
    const Kerb kerb{centre, segment.half_width, pavement_m, cut_first + first.clear_m,
                    length(centre) - cut_last - last.clear_m};
    // Traffic along this kerb keeps the block on its right: against the side's direction, except in one-way
    // streets.
    const bool with_side = street.profile.lanes_backward == 0 && !side.reversed;
    const bool against_side = street.profile.lanes_backward > 0 || side.reversed;
    park(kerb, side.reversed ? street.profile.parking_right_m : street.profile.parking_left_m, with_side,
         substream(stream, 10 * side.segment + side.reversed));
    Draws draws{substream(stream, 5000 + 10 * side.segment + side.reversed)};
    light(kerb, street.profile.lanes_forward + street.profile.lanes_backward > 2, draws);
    if (against_side) sign(kerb, cut_first, first, street.profile, draws);
    plant_avenue(kerb, draws);
    equip(kerb, cut_first, first, draws);
    walk(kerb, Draws{substream(stream, 9000 + 10 * side.segment + side.reversed)});
  }

  void plant_gardens() {
    Draws draws{substream(stream, 1)};
    const bool park = plan.kind == BlockKind::park;
    for (const Vec2& p : plan.trees) {
      const double pick = draws.uniform(0, 1), scale = draws.uniform(0.75, 1.15);
      const int species = park ? (pick < 0.35   ? lime
                                  : pick < 0.55 ? plane
                                  : pick < 0.8  ? maple
                                  : pick < 0.9  ? shrub
                                                : spruce)
                               : (pick < 0.3    ? maple
                                  : pick < 0.5  ? hornbeam
                                  : pick < 0.6  ? spruce
                                  : pick < 0.75 ? young
                                                : shrub);
      place_tree(species, p, scale, draws);
    }
  }

  /// Cars on driveways and in yards, goods, fences and hedges.
  void furnish_lots() {
    Draws draws{substream(stream, 2)};
    for (const Spot& spot : plan.car_spots) {
      const Model& model = draws.one_of(draws.one_of(models.cars));
      if (draws.chance(std::min(1.0, 0.8 * options.parked_cars)))
        try_place({&model, spot.position, kerb_height_m + spot.rise_m, angle_of(spot.direction), 1});
    }
    for (const Spot& spot : plan.goods_spots) {
      const bool is_lorry = draws.chance(0.35);
      const Model& model = draws.one_of(is_lorry ? models.lorries : models.goods);
      const double heading = angle_of(spot.direction) + (draws.chance(0.2) ? std::numbers::pi / 2 : 0.0);
      try_place({&model, spot.position, kerb_height_m, heading, 1});
    }
    for (const Boundary& boundary : plan.boundaries) enclose(boundary);
  }

 private:
  /// A kerb as seen from the block: stations run along it, `inset` leads into the block.
  struct Kerb {
    const Polyline& centre;
    double half_width, pavement_m, from, to;

    Vec2 at(double s, double inset) const {
      const Station station = station_at(centre, s);
      return station.point + left_of(station.direction) * (half_width + inset);
    }
    Vec2 direction(double s) const { return station_at(centre, s).direction; }
    /// Heading of something whose +x faces the carriageway.
    double facing(double s) const { return angle_of(-left_of(direction(s))); }
  };

  bool try_place(const PlacedModel& model) {
    const Polygon ground = model.footprint();
    const auto hits = [&](const Polygon& other) { return overlap(ground, other, 0); };
    for (const PlacedModel& p : placed)
      if ((p.position - model.position).norm() < 8 && hits(p.footprint())) return false;
    for (const BuildingPlan& b : plan.buildings) {
      const Polygon wing = rear_wing(b);
      if (hits(b.footprint.polygon()) || (!wing.empty() && hits(wing))) return false;
    }
    placed.push_back(model);
    return true;
  }

  void place_tree(int species, const Vec2& p, double scale, Draws& draws) {
    const Model& model = draws.one_of(models.trees[species]);
    const double heading = draws.uniform(0, 2 * std::numbers::pi);
    if (!draws.chance(std::min(1.0, options.tree_density))) return;
    for (const BuildingPlan& b : plan.buildings) {  // crowns may touch a facade, not grow into it
      const double room = distance_to_polygon(b.footprint.polygon(), p);
      scale = std::min(scale, std::max(0.0, room + 0.1) / model.crown_radius);
    }
    if (scale > 0.45) try_place({&model, p, kerb_height_m, heading, scale});
  }

  /// A line of modules, scaled a little so that they fill it.
  void enclose(const Boundary& boundary) {
    const double total = length(boundary.line);
    const int count = std::max(1, static_cast<int>(std::lround(total / boundary_module_m)));
    const double step = total / count;
    for (int k = 0; k < count; ++k) {
      const Vec2 from = station_at(boundary.line, k * step).point,
                 to = station_at(boundary.line, (k + 1) * step).point;
      try_place({&models.boundaries[static_cast<int>(boundary.kind)], (from + to) / 2, kerb_height_m,
                 angle_of(to - from), std::min((to - from).norm() / boundary_module_m, 1.25)});
    }
  }

  void park(const Kerb& kerb, double parking_m, bool with_side, Stream own) {
    if (parking_m <= 0) return;
    Draws draws{own};
    const double occupied = std::min(1.0, draws.uniform(0.35, 0.9) * options.parked_cars);
    double s = kerb.from + 0.5;
    while (s < kerb.to) {
      const double pick = draws.uniform(0, 1);
      const int kind = pick < 0.3    ? 0
                       : pick < 0.45 ? 1
                       : pick < 0.65 ? 2
                       : pick < 0.8  ? 3
                       : pick < 0.93 ? 4
                                     : 5;
      const Model& model = draws.one_of(models.cars[kind]);
      const double gap = draws.uniform(0.10, 0.22), space = draws.uniform(0.5, 1.4),
                   turn = draws.uniform(-0.012, 0.012);
      const double reach =
          2 * model.half_width + 0.06 - 0.17;  // the mirror towards the pavement overhangs the kerb
      const bool parked =
          draws.chance(occupied) && gap + reach <= parking_m && s + 2 * model.half_length < kerb.to;
      if (parked) {
        const double middle = s + model.half_length;
        const Vec2 direction = with_side ? kerb.direction(middle) : Vec2(-kerb.direction(middle));
        try_place(
            {&model, kerb.at(middle, -gap - (model.half_width - 0.17)), 0, angle_of(direction) + turn, 1});
      }
      s += 2 * model.half_length + space;
    }
  }

  void light(const Kerb& kerb, bool wide, Draws& draws) {
    const bool both_sides = wide || draws.chance(0.5);
    const double spacing = both_sides ? draws.uniform(26, 34) : draws.uniform(38, 48);
    for (double s = kerb.from + draws.uniform(2, 14); s < kerb.to; s += spacing)
      try_place({wide ? &models.tall_lamp : &models.lamp, kerb.at(s, 0.5), kerb_height_m, kerb.facing(s), 1});
  }

  void sign(const Kerb& kerb, double cut, const Approach& approach, const StreetProfile& profile,
            Draws& draws) {
    const double s = cut + approach.stop_line_at_m + 0.4;
    if (approach.crossing && profile.kind != "residential" && draws.chance(0.6)) {
      const bool green = draws.chance(0.5);
      try_place({green ? &models.traffic_light_green : &models.traffic_light_red, kerb.at(s, 0.5),
                 kerb_height_m, kerb.facing(s), 1});
    } else if (approach.stop_line) {
      const SignKind kind = approach.crossing   ? SignKind::crossing
                            : draws.chance(0.6) ? SignKind::yield
                                                : SignKind::priority;
      try_place({&models.signs[static_cast<int>(kind)], kerb.at(s, 0.65), kerb_height_m, kerb.facing(s), 1});
    }
    for (double t = kerb.from + draws.uniform(4, 25); t < kerb.to; t += draws.uniform(25, 60)) {
      const SignKind kind = draws.chance(0.4)   ? SignKind::parking
                            : draws.chance(0.5) ? SignKind::no_stopping
                                                : SignKind::speed;
      try_place({&models.signs[static_cast<int>(kind)], kerb.at(t, 0.65), kerb_height_m, kerb.facing(t), 1});
    }
  }

  void plant_avenue(const Kerb& kerb, Draws& draws) {
    const double room = kerb.pavement_m - 0.9 + (plan.kind == BlockKind::closed ? 0.0 : 2.5);
    const int species = room > 4.2 ? draws.one_of<int>({lime, plane, maple})
                        : room > 3 ? draws.one_of<int>({maple, hornbeam, lime})
                                   : draws.one_of<int>({hornbeam, young});
    const bool planted = draws.chance(std::min(1.0, 0.45 * character.tree_density * options.tree_density));
    const double spacing = draws.uniform(7.5, 13), scale = draws.uniform(0.8, 1.15);
    if (!planted) return;
    for (double s = kerb.from + draws.uniform(0, spacing); s < kerb.to;
         s += spacing * draws.uniform(0.9, 1.15))
      place_tree(species, kerb.at(s, 0.95), scale * draws.uniform(0.9, 1.1), draws);
  }

  void equip(const Kerb& kerb, double cut, const Approach& approach, Draws& draws) {
    if (approach.crossing && draws.chance(0.35))
      for (double s = cut + 0.3; s < cut + approach.stop_line_at_m + 5; s += 1.5)
        if (s < cut + approach.crossing_from_m ||
            s > cut + approach.crossing_from_m + approach.crossing_length_m)
          try_place({&models.bollard, kerb.at(s, 0.35), kerb_height_m, kerb.facing(s), 1});
    for (double s = kerb.from + draws.uniform(5, 40); s < kerb.to; s += draws.uniform(25, 70)) {
      const double pick = draws.uniform(0, 1);
      if (pick < 0.4)
        try_place({&models.bin, kerb.at(s, 0.75), kerb_height_m, kerb.facing(s), 1});
      else if (pick < 0.7 && kerb.pavement_m > 3)
        try_place({&models.bench, kerb.at(s, kerb.pavement_m - 0.6), kerb_height_m, kerb.facing(s), 1});
      else
        try_place({&models.switch_box, kerb.at(s, kerb.pavement_m - 0.35), kerb_height_m, kerb.facing(s), 1});
    }
  }

  /// People on the pavement: more where there are shops and towers.
  void walk(const Kerb& kerb, Draws draws) {
    const bool busy = plan.kind == BlockKind::closed || plan.kind == BlockKind::towers;
    const double spacing = draws.uniform(0.6, 1.8) * (busy ? 16 : 55);
    for (double s = kerb.from + draws.uniform(0, spacing); s < kerb.to;
         s += spacing * draws.uniform(0.3, 1.7)) {
      const double inset = draws.uniform(0.8, std::max(0.9, kerb.pavement_m - 0.6));
      const Vec2 along = draws.chance(0.5) ? kerb.direction(s) : Vec2(-kerb.direction(s));
      try_place({&draws.one_of(models.people), kerb.at(s, inset), kerb_height_m,
                 angle_of(along) + draws.uniform(-0.4, 0.4), 1});
    }
  }

  const StreetNetwork& network;
  const BlockPlan& plan;
  const ModelLibrary& models;
  const CityOptions& options;
  const CityCharacter& character;
  Stream stream;
};

}  // namespace

std::vector<PlacedModel> furnish(const StreetNetwork& network, int block, const BlockPlan& plan,
                                 const ModelLibrary& models, const CityCharacter& character,
                                 const CityOptions& options) {
  Furnisher furnisher(network, plan, models, options, character,
                      substream(make_stream(options.seed, "roadside"), block));
  const std::vector<Side>& sides = network.blocks[block].sides;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (network.is_road(sides[i])) furnisher.furnish_side(sides[i], plan.pavement_m[i], options.seed);
  furnisher.furnish_lots();
  furnisher.plant_gardens();
  return std::move(furnisher.placed);
}

}  // namespace cps::city
