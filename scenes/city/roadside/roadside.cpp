#include "scenes/city/roadside/roadside.h"

#include <algorithm>
#include <numbers>

#include "scenes/city/roadside/furniture/boundary.h"
#include "scenes/city/roadside/furniture/bus_stop.h"
#include "scenes/city/roadside/furniture/signals.h"
#include "scenes/city/roadside/overhead/overhead.h"
#include "scenes/city/roadside/parked_and_walking.h"
#include "scenes/city/roadside/pavement_tracks.h"
#include "scenes/city/roadside/tree.h"
#include "scenes/city/streets/surface/heights.h"

namespace cps::city {
namespace {

/// Species to draw from; a species is as frequent as it is listed.
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

/// How far crowns (their outermost leaves) may reach over a lane.
constexpr double crown_over_lane_m = 0.4;

class Furnisher {
 public:
  Furnisher(const StreetNetwork& network, const std::vector<KerbSide>& kerbs, StandingRoom& room,
            const ModelLibrary& models, const CityOptions& options, const CityCharacter& character,
            Stream stream)
      : network(network),
        kerbs(kerbs),
        plan(room.plan),
        room(room),
        models(models),
        options(options),
        character(character),
        stream(stream) {}

  void furnish_side(const KerbSide& kerb) {
    const Side& side = kerb.side;
    const StreetProfile& profile = network.profile(side);
    const Overhead overhead = overhead_along(network, side.segment, options);
    for (const Mast& mast : overhead.masts)
      if (mast.side == side)
        room.try_place({overhead.kind == OverheadKind::telegraph ? &models.telegraph_mast : &models.span_mast,
                        mast.position, kerb_height_m, mast.heading_rad, 1});
    const bool has_wires =
        !overhead.masts.empty() && (overhead.masts[0].side == side || overhead.kind == OverheadKind::tram);
    const int thing = 10 * side.segment + side.reversed;
    if (kerb.bus_stop) add_bus_stop(kerb, Draws{substream(stream, 13000 + thing)});
    Draws draws{substream(stream, 5000 + thing)};
    // With wires, lamps hang from the wires or from their masts.
    if (!has_wires && overhead.kind != OverheadKind::span)
      light(kerb, profile.lanes_forward + profile.lanes_backward > 2, draws);
    if (kerb.meets_traffic) sign(kerb, draws);
    if (!has_wires) plant_avenue(kerb, draws);
    equip(kerb, draws);
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

  /// Places goods, fences and hedges.
  void furnish_lots() {
    Draws draws{substream(stream, 2)};
    for (const Spot& spot : plan.goods_spots) {
      const bool is_lorry = draws.chance(0.35);
      const Model& model = draws.one_of(is_lorry ? models.lorries : models.goods);
      const double heading = angle_of(spot.direction) + (draws.chance(0.2) ? std::numbers::pi / 2 : 0.0);
      room.try_place({&model, spot.position, kerb_height_m, heading, 1});
    }
    for (const Boundary& boundary : plan.boundaries) enclose(boundary);
  }

 private:
  void place_tree(int species, const Vec2& p, double scale, Draws& draws) {
    const Model& model = draws.one_of(models.trees[species]);
    const double heading = draws.uniform(0, 2 * std::numbers::pi);
    if (!draws.chance(std::min(1.0, options.tree_density))) return;
    for (const BuildingPlan& b : plan.buildings) {  // crowns may touch a facade, but not reach into it
      const double free_m = distance_to_polygon(b.footprint.polygon(), p);
      scale = std::min(scale, std::max(0.0, free_m + 0.1) / model.crown_radius);
    }
    for (const KerbSide& kerb : kerbs) {  // nor reach where lorries drive
      const double free_m = distance_to_line(kerb.centre, p) - kerb.half_width + edge_m(kerb);
      scale = std::min(scale, std::max(0.0, free_m + crown_over_lane_m) / model.crown_radius);
    }
    if (scale > 0.45) room.try_place({&model, p, kerb_height_m, heading, scale});
  }

  /// Places modules along a boundary, scaled a little so that they fill it.
  void enclose(const Boundary& boundary) {
    const double total = length(boundary.line);
    const int count = std::max(1, static_cast<int>(std::lround(total / boundary_module_m)));
    const double step = total / count;
    for (int k = 0; k < count; ++k) {
      const Vec2 from = station_at(boundary.line, k * step).point,
                 to = station_at(boundary.line, (k + 1) * step).point;
      room.try_place({&models.boundaries[static_cast<int>(boundary.kind)], (from + to) / 2, kerb_height_m,
                      angle_of(to - from), std::min((to - from).norm() / boundary_module_m, 1.25)});
    }
  }

  void add_bus_stop(const KerbSide& kerb, Draws draws) {
    const double s = kerb.bus_stop->sign_m, waiting = s + draws.uniform(3, 6);
    room.try_place({&models.bus_stop_sign, kerb.at(s, 0.5), kerb_height_m, kerb.facing(s), 1});
    constexpr double way_past_m = 1.2;
    const double inset = kerb.pavement_m - shelter_half_depth_m - 0.1;
    if (inset - shelter_half_depth_m > way_past_m)
      room.try_place({&models.bus_shelter, kerb.at(waiting, inset), kerb_height_m, kerb.facing(waiting), 1});
  }

  void light(const KerbSide& kerb, bool wide, Draws& draws) {
    const bool both_sides = wide || draws.chance(0.5);
    const double spacing = both_sides ? draws.uniform(26, 34) : draws.uniform(38, 48);
    for (double s = kerb.from + draws.uniform(2, 14); s < kerb.to; s += spacing)
      room.try_place(
          {wide ? &models.tall_lamp : &models.lamp, kerb.at(s, 0.5), kerb_height_m, kerb.facing(s), 1});
  }

  void sign(const KerbSide& kerb, Draws& draws) {
    const double s = kerb.cut_m + kerb.approach.stop_line_at_m + 0.4;
    const Signal signal = signal_at(network, kerb.side.segment, kerb.side.reversed, options);
    if (signal != Signal::none) {
      const bool green = signal == Signal::green;
      room.try_place({green ? &models.traffic_light_green : &models.traffic_light_red, kerb.at(s, 0.5),
                      kerb_height_m, kerb.facing(s), 1});
    } else if (network.junctions[network.start(kerb.side)].roundabout) {
      room.try_place({&models.signs[static_cast<int>(SignKind::yield)], kerb.at(s, 0.65), kerb_height_m,
                      kerb.facing(s), 1});
    } else if (kerb.approach.stop_line) {
      const SignKind kind = kerb.approach.crossing ? SignKind::crossing
                            : draws.chance(0.6)    ? SignKind::yield
                                                   : SignKind::priority;
      room.try_place(
          {&models.signs[static_cast<int>(kind)], kerb.at(s, 0.65), kerb_height_m, kerb.facing(s), 1});
    }
    for (double t = kerb.from + draws.uniform(4, 25); t < kerb.to; t += draws.uniform(25, 60)) {
      const SignKind kind = draws.chance(0.4)   ? SignKind::parking
                            : draws.chance(0.5) ? SignKind::no_stopping
                                                : SignKind::speed;
      room.try_place(
          {&models.signs[static_cast<int>(kind)], kerb.at(t, 0.65), kerb_height_m, kerb.facing(t), 1});
    }
  }

  void plant_avenue(const KerbSide& kerb, Draws& draws) {
    const double width_m = kerb.pavement_m - 0.9 + (plan.kind == BlockKind::closed ? 0.0 : 2.5);
    const bool beside_lane = edge_m(kerb) < 1;
    const int species = beside_lane     ? draws.one_of<int>({hornbeam, young, globe, young})
                        : width_m > 4.2 ? draws.one_of<int>({lime, plane, maple, birch, poplar, plane})
                        : width_m > 3   ? draws.one_of<int>({maple, hornbeam, lime, birch, plum})
                                        : draws.one_of<int>({hornbeam, young, globe, plum});
    const bool planted = draws.chance(std::min(1.0, 0.45 * character.tree_density * options.tree_density));
    const double spacing = draws.uniform(7.5, 13), scale = draws.uniform(0.8, 1.15);
    if (!planted) return;
    for (double s = kerb.from + draws.uniform(0, spacing); s < kerb.to;
         s += spacing * draws.uniform(0.9, 1.15))
      place_tree(species, kerb.at(s, 0.95), scale * draws.uniform(0.9, 1.1), draws);
  }

  void equip(const KerbSide& kerb, Draws& draws) {
    const Approach& approach = kerb.approach;
    if (approach.crossing && draws.chance(0.35))
      for (double s = kerb.cut_m + 0.3; s < kerb.cut_m + approach.stop_line_at_m + 5; s += 1.5)
        if (s < kerb.cut_m + approach.crossing_from_m ||
            s > kerb.cut_m + approach.crossing_from_m + approach.crossing_length_m)
          room.try_place({&models.bollard, kerb.at(s, 0.35), kerb_height_m, kerb.facing(s), 1});
    for (double s = kerb.from + draws.uniform(5, 40); s < kerb.to; s += draws.uniform(25, 70)) {
      const double pick = draws.uniform(0, 1);
      if (pick < 0.2) {
        const double along = angle_of(kerb.direction(s));
        for (int left = draws.integer(1, 4), row = 0; row < left; ++row)  // side by side at a stand
          room.try_place({&draws.one_of(models.bicycles), kerb.at(s + 0.75 * row, kerb.pavement_m - 1.0),
                          kerb_height_m, along + std::numbers::pi / 2, 1});
      } else if (pick < 0.5)
        room.try_place({&models.bin, kerb.at(s, 0.75), kerb_height_m, kerb.facing(s), 1});
      else if (pick < 0.75 && kerb.pavement_m > 3)
        room.try_place({&models.bench, kerb.at(s, kerb.pavement_m - 0.6), kerb_height_m, kerb.facing(s), 1});
      else
        room.try_place(
            {&models.switch_box, kerb.at(s, kerb.pavement_m - 0.35), kerb_height_m, kerb.facing(s), 1});
    }
  }

  /// Width between the kerb and the nearest lane.
  double edge_m(const KerbSide& kerb) const {
    const StreetProfile& profile = network.profile(kerb.side);
    return kerb.side.reversed ? profile.edge_right_m() : profile.edge_left_m();
  }

  const StreetNetwork& network;
  const std::vector<KerbSide>& kerbs;
  const BlockPlan& plan;
  StandingRoom& room;
  const ModelLibrary& models;
  const CityOptions& options;
  const CityCharacter& character;
  Stream stream;
};

}  // namespace

std::vector<PlacedModel> furnish(const StreetNetwork& network, int block, const BlockPlan& plan,
                                 const ModelLibrary& models, const CityCharacter& character,
                                 const CityOptions& options) {
  const std::vector<Side>& sides = network.blocks[block].sides;
  std::vector<KerbSide> kerbs;
  for (std::size_t i = 0; i < sides.size(); ++i)
    if (network.is_road(sides[i])) kerbs.push_back(kerb_side(network, sides[i], plan.pavement_m[i], options));
  StandingRoom room{plan};
  std::vector<Polygon> tracks;
  for (const KerbSide& kerb : kerbs) {
    const Polyline track = pavement_track(network, kerb);
    if (track.empty()) continue;
    const double half = network.profile(kerb.side).pavement_cycle_m / 2;
    const Polyline left = offset(track, half), right = offset(track, -half);
    for (std::size_t i = 1; i < track.size(); ++i)
      tracks.push_back({right[i - 1], right[i], left[i], left[i - 1]});
  }
  room.kept_free = tracks;
  for (const Spot& spot : plan.car_spots) room.kept_free.push_back(car_ground(spot));
  Furnisher furnisher(network, kerbs, room, models, options, character,
                      substream(make_stream(options.seed, "roadside"), block));
  for (const KerbSide& kerb : kerbs) furnisher.furnish_side(kerb);
  furnisher.furnish_lots();
  furnisher.plant_gardens();
  room.kept_free = std::move(tracks);
  // Last, so that fixed things do not depend on what moves.
  add_parked_cars_and_people(room, network, kerbs, block, models, options);
  return std::move(room.placed);
}

}  // namespace cps::city
