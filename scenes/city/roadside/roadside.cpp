#include "scenes/city/roadside/roadside.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/city/roadside/boundary.h"
#include "scenes/city/roadside/bus_stop.h"
#include "scenes/city/roadside/overhead.h"
#include "scenes/city/roadside/signals.h"
#include "scenes/city/roadside/tree.h"
#include "scenes/city/roadside/vehicle.h"
#include "scenes/city/streets/road_markings.h"
#include "scenes/city/streets/road_surface.h"

namespace cps::city {
namespace {

/// What grows where, each as often as it is named.
const std::vector<int>& park_trees() {
  static const std::vector<int> trees{lime,  lime,  lime,  lime,   plane, plane, plane, maple, maple, maple,
                                      birch, birch, birch, poplar, pine,  pine,  plum,  shrub, shrub, spruce};
  return trees;
}

const std::vector<int>& garden_trees() {
  static const std::vector<int> trees{maple, maple, maple, hornbeam, hornbeam, birch, birch,
                                      plum,  plum,  globe, spruce,   spruce,   pine,  young,
                                      young, shrub, shrub, shrub,    shrub,    shrub};
  return trees;
}

double angle_of(const Vec2& direction) {
  return std::atan2(direction.y(), direction.x());
}

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
    const Overhead overhead = overhead_along(network, side.segment, options);
    for (const Mast& mast : overhead.masts)
      if (mast.side == side)
        try_place({overhead.kind == OverheadKind::span ? &models.span_mast : &models.telegraph_mast,
                   mast.position, kerb_height_m, mast.heading_rad, 1});
    const bool has_wires = !overhead.masts.empty() && overhead.masts[0].side == side;
    bus_bay = {};
    if (against_side && street.profile.kind != "residential")
      stop_buses(kerb, Draws{substream(stream, 13000 + 10 * side.segment + side.reversed)});
    park(kerb, side.reversed ? street.profile.parking_right_m : street.profile.parking_left_m, with_side,
         substream(stream, 10 * side.segment + side.reversed));
    Draws draws{substream(stream, 5000 + 10 * side.segment + side.reversed)};
    if (!has_wires && overhead.kind != OverheadKind::span)  // lamps hang from the wires or are on their masts
      light(kerb, street.profile.lanes_forward + street.profile.lanes_backward > 2, draws);
    if (against_side)
      sign(kerb, cut_first, first, signal_at(network, side.segment, side.reversed, seed),
           network.junctions[network.start(side)].roundabout.has_value(), draws);
    if (!has_wires) plant_avenue(kerb, draws);
    equip(kerb, cut_first, first, draws);
    walk(kerb, Draws{substream(stream, 9000 + 10 * side.segment + side.reversed)});
  }

  void plant_gardens() {
    Draws draws{substream(stream, 1)};
    const bool park = plan.kind == BlockKind::park;
    for (const Vec2& p : plan.trees) {
      const double pick = draws.uniform(0, 1), scale = draws.uniform(0.75, 1.15);
      const std::vector<int>& grown = park ? park_trees() : garden_trees();
      place_tree(grown[static_cast<std::size_t>(pick * static_cast<double>(grown.size()))], p, scale, draws);
    }
  }

  /// Cars on driveways and in yards, goods, fences and hedges.
  void furnish_lots() {
    Draws draws{substream(stream, 2)};
    for (const Spot& spot : plan.car_spots) {
      const Model& model = draw_car(draws, models);
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

  /// A stop, its sign where a bus's nose comes to stand; nobody parks behind it.
  void stop_buses(const Kerb& kerb, Draws draws) {
    const bool has_stop = draws.chance(0.35);
    const double s = kerb.from + draws.uniform(3, 12), waiting = s + draws.uniform(3, 6);
    if (!has_stop || s + bus_bay_m > kerb.to) return;
    try_place({&models.bus_stop_sign, kerb.at(s, 0.5), kerb_height_m, kerb.facing(s), 1});
    bus_bay = {s - 1, s + bus_bay_m};
    constexpr double way_past_m = 1.2;
    const double inset = kerb.pavement_m - shelter_half_depth_m - 0.1;
    if (inset - shelter_half_depth_m > way_past_m)
      try_place({&models.bus_shelter, kerb.at(waiting, inset), kerb_height_m, kerb.facing(waiting), 1});
  }

  void park(const Kerb& kerb, double parking_m, bool with_side, Stream own) {
    if (parking_m <= 0) return;
    Draws draws{own};
    const double occupied = std::min(1.0, draws.uniform(0.35, 0.9) * options.parked_cars);
    double s = kerb.from + 0.5;
    while (s < kerb.to) {
      const Model& model = draw_car(draws, models);
      const double gap = draws.uniform(0.10, 0.22), space = draws.uniform(0.5, 1.4),
                   turn = draws.uniform(-0.012, 0.012);
      const double reach =
          2 * model.half_width + 0.06 - mirror_m;  // the mirror towards the pavement overhangs the kerb
      const bool parked = draws.chance(occupied) && gap + reach <= parking_m &&
                          s + 2 * model.half_length < kerb.to &&
                          (s > bus_bay[1] || s + 2 * model.half_length < bus_bay[0]);
      if (parked) {
        const double middle = s + model.half_length;
        const Vec2 direction = with_side ? kerb.direction(middle) : Vec2(-kerb.direction(middle));
        try_place({&model, kerb.at(middle, -gap - (model.half_width - mirror_m)), 0,
                   angle_of(direction) + turn, 1});
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

  void sign(const Kerb& kerb, double cut, const Approach& approach, Signal signal, bool gives_way,
            Draws& draws) {
    const double s = cut + approach.stop_line_at_m + 0.4;
    if (signal != Signal::none) {
      const bool green = signal == Signal::green;
      try_place({green ? &models.traffic_light_green : &models.traffic_light_red, kerb.at(s, 0.5),
                 kerb_height_m, kerb.facing(s), 1});
    } else if (gives_way) {
      try_place({&models.signs[static_cast<int>(SignKind::yield)], kerb.at(s, 0.65), kerb_height_m,
                 kerb.facing(s), 1});
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
    const int species = room > 4.2 ? draws.one_of<int>({lime, plane, maple, birch, poplar, plane})
                        : room > 3 ? draws.one_of<int>({maple, hornbeam, lime, birch, plum})
                                   : draws.one_of<int>({hornbeam, young, globe, plum});
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
      if (pick < 0.2) {
        const double along = angle_of(kerb.direction(s));
        for (int left = draws.integer(1, 4), row = 0; row < left; ++row)  // at a stand, side by side
          try_place({&draws.one_of(models.bicycles), kerb.at(s + 0.75 * row, kerb.pavement_m - 1.0),
                     kerb_height_m, along + std::numbers::pi / 2, 1});
      } else if (pick < 0.5)
        try_place({&models.bin, kerb.at(s, 0.75), kerb_height_m, kerb.facing(s), 1});
      else if (pick < 0.75 && kerb.pavement_m > 3)
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

  static constexpr double bus_bay_m = 15;
  std::array<double, 2> bus_bay = {};  ///< stations of the kerb in hand where nobody parks

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
