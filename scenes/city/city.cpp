#include "scenes/city/city.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "scenes/city/blocks/block_plan.h"
#include "scenes/city/buildings/foundation.h"
#include "scenes/city/geometry/glb_writer.h"
#include "scenes/city/geometry/refine.h"
#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/materials.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/roadside/model_library.h"
#include "scenes/city/roadside/overhead/overhead.h"
#include "scenes/city/roadside/overhead/tram_wires.h"
#include "scenes/city/roadside/pavement_tracks.h"
#include "scenes/city/roadside/roadside.h"
#include "scenes/city/roadside/surroundings.h"
#include "scenes/city/roadside/traffic.h"
#include "scenes/city/roadside/tree.h"
#include "scenes/city/streets/driving_lanes.h"
#include "scenes/city/streets/roundabout.h"
#include "scenes/city/streets/street_grid.h"
#include "scenes/city/streets/street_network.h"
#include "scenes/city/streets/surface/cycle_tracks.h"
#include "scenes/city/streets/surface/heights.h"
#include "scenes/city/streets/surface/junction_details.h"
#include "scenes/city/streets/surface/median.h"
#include "scenes/city/streets/surface/road_markings.h"
#include "scenes/city/streets/surface/road_surface.h"
#include "scenes/city/streets/surface/roundabout_island.h"
#include "scenes/city/streets/surface/tram_tracks.h"
#include "scenes/city/streets/terrain.h"

namespace cps {

using namespace city;

std::string CityOptions::fault() const {
  if (!(extent_m >= 300 && extent_m <= 1200)) return "extent_m: must lie in [300, 1200] metres";
  if (!(tree_density >= 0 && tree_density <= 3)) return "tree_density: must lie in [0, 3]";
  if (!(parked_cars >= 0 && parked_cars <= 2)) return "parked_cars: must lie in [0, 2]";
  if (!(traffic >= 0 && traffic <= 2)) return "traffic: must lie in [0, 2]";
  return "";
}

std::string CitySummary::brief() const {
  return fmt::format(
      "{}: {} streets, {} junctions, {} blocks, {} buildings, {} trees, {} parked cars, "
      "{} vehicles in traffic, {} people, {} pieces of street furniture\n"
      "{} lanes, {:.1f} km in all\n"
      "{:.2f} M triangles ({:.2f} M with instances), {:.1f} MB",
      to_string(style), streets, junctions, blocks, buildings, trees, cars, in_traffic, people, furniture,
      lanes, lane_km, triangles * 1e-6, instanced_triangles * 1e-6, bytes * 1e-6);
}

namespace {

void add_static(GlbWriter& writer, Mesh mesh, const std::string& name, double level_m = 0) {
  if (mesh.empty()) return;
  mesh.name = name;
  writer.add_node(name, writer.add_mesh(mesh), {Vec3(0, level_m, 0)});
}

void add_ground(GlbWriter& writer, Mesh mesh, const std::string& name, const Terrain& terrain) {
  drape(mesh, terrain);
  add_static(writer, std::move(mesh), name);
}

WallMaterial ground_material(const Materials& m, GroundKind kind) {
  switch (kind) {
    case GroundKind::grass:
      return {m.grass, grass_tile_m};
    case GroundKind::paving:
      return {m.paving, paving_tile_m};
    case GroundKind::asphalt:
      return {m.asphalt, asphalt_tile_m};
    case GroundKind::concrete:
      return {m.concrete[0].material, concrete_tile_m};
  }
  return {};
}

void add_street(GlbWriter& writer, const StreetNetwork& network, int index, const Materials& materials,
                const Terrain& terrain, const CityOptions& options) {
  const std::string& name = network.streets[index].name;
  add_ground(writer, carriageway(network, index, materials, options.seed), "street " + name, terrain);
  add_ground(writer, road_markings(network, index, materials, options.seed), "markings " + name, terrain);
  add_ground(writer, cycle_tracks(network, index, materials, options.seed), "cycle tracks " + name, terrain);
  add_ground(writer, pavement_tracks(network, index, materials, options), "pavement tracks " + name, terrain);
  add_ground(writer, median(network, index, materials, options.seed), "median " + name, terrain);
  for (Mesh wires :
       {overhead_wires(network, index, materials, options), tram_wires(network, index, materials, options)}) {
    lift_onto(wires, terrain);
    const std::string own_name = wires.name;
    add_static(writer, std::move(wires), own_name);
  }
}

void add_junction(GlbWriter& writer, const StreetNetwork& network, int index,
                  const std::vector<DrivingLane>& lanes, const Materials& materials, const Terrain& terrain,
                  std::uint64_t seed) {
  const Junction& junction = network.junctions[index];
  const std::string name = "junction " + std::to_string(index);
  add_ground(writer, junction_floor(network, index, materials, seed), name, terrain);
  add_ground(writer, junction_details(network, index, lanes, materials, seed), name + " details", terrain);
  if (!junction.roundabout) return;
  add_ground(writer, island(*junction.roundabout, junction.position, materials), name + " island", terrain);
}

void add_building(GlbWriter& writer, const BuildingPlan& plan, const Materials& materials,
                  const Terrain& terrain, Stream stream, const std::string& name) {
  Building built = building(plan, materials, stream);
  const double level_m = ground_level_m(built, plan, terrain);
  add_foundation(built, plan, level_m, terrain, materials);
  add_static(writer, std::move(built.mesh), name, level_m);
}

void add_block(GlbWriter& writer, const StreetNetwork& network, int index, const BlockPlan& plan,
               const Materials& materials, const Terrain& terrain, std::uint64_t seed) {
  const std::string name = "block " + std::to_string(index);
  Mesh ground = pavement(network, network.blocks[index], plan.pavement_m, materials);
  const WallMaterial surface = ground_material(materials, plan.ground);
  add_floor(ground.surfaces[surface.material], plan.border.points, kerb_height_m, surface.tile_m);
  for (const Pad& pad : plan.pads) {
    const WallMaterial cover = ground_material(materials, pad.kind);
    add_floor(ground.surfaces[cover.material], pad.outline, kerb_height_m + pad_rise_m, cover.tile_m);
  }
  // The gutter lies on the asphalt, so it is refined as finely.
  refine(ground.surfaces[materials.gutter], max_road_edge_m);
  for (auto& [material, piece] : ground.surfaces) {
    if (material == materials.kerb || material == materials.gutter) continue;
    refine(piece, max_block_edge_m);  // enough vertices for the weathering colours
    shade(piece, [stream = make_stream(seed, "weathering")](const Vec2& p) { return weathering(stream, p); });
  }
  drape(ground, terrain, max_block_edge_m);
  add_static(writer, std::move(ground), name);
  const Stream buildings = substream(make_stream(seed, "building"), index);
  for (std::size_t k = 0; k < plan.buildings.size(); ++k)
    add_building(writer, plan.buildings[k], materials, terrain, substream(buildings, k),
                 name + " building " + std::to_string(k));
}

/// Whether models of this kind tilt with the slope (wheeled or lying flat) rather than stand upright.
bool leans(ModelKind kind) {
  return kind == ModelKind::car || kind == ModelKind::cyclist || kind == ModelKind::goods;
}

void stand(GlbWriter& writer, const PlacedModel& p, const Terrain& terrain) {
  const Vec2 slope = terrain.slope(p.position);
  const Vec3 up = leans(p.model->kind) ? lift(-slope, 1).normalized() : Vec3(0, 1, 0);
  writer.add_node(p.model->name, p.model->mesh,
                  {lift(p.position, p.height + terrain.height_m(p.position)), p.heading_rad, p.scale, up});
}

void place(GlbWriter& writer, const std::vector<PlacedModel>& placed, const Terrain& terrain,
           CitySummary& summary) {
  for (const PlacedModel& p : placed) {
    switch (p.model->kind) {
      case ModelKind::tree:
        ++summary.trees;
        break;
      case ModelKind::car:
        ++summary.cars;
        break;
      case ModelKind::cyclist:
        ++summary.in_traffic;
        break;
      case ModelKind::person:
        ++summary.people;
        break;
      case ModelKind::house:
        ++summary.buildings;
        break;
      case ModelKind::boundary:
      case ModelKind::goods:
      case ModelKind::furniture:
        ++summary.furniture;
        break;
    }
    stand(writer, p, terrain);
  }
}

double to_whole_mm(double metres) {
  return std::round(metres * 1e3) / 1e3;
}

nlohmann::ordered_json lanes_as_json(const StreetNetwork& network, const std::vector<DrivingLane>& lanes,
                                     const Traffic& traffic, const Terrain& terrain) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    const DrivingLane& lane = lanes[i];
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const Vec3& p : on_terrain(lane.points, terrain))
      points.push_back({to_whole_mm(p.x()), to_whole_mm(p.y()), to_whole_mm(p.z())});
    list.push_back({{"street", network.streets[lane.street].name},
                    {"width_m", to_whole_mm(lane.width_m)},
                    {"points", std::move(points)},
                    {"next", lane.next}});
    for (const OccupiedStretch& o : traffic.occupied[i])
      list.back()["occupied"].push_back({to_whole_mm(o.from_m), to_whole_mm(o.to_m)});
  }
  return list;
}

}  // namespace

CitySummary write_city(const CityOptions& options, const std::filesystem::path& file) {
  if (const std::string fault = options.fault(); !fault.empty()) throw std::runtime_error("city: " + fault);
  const StreetNetwork network = draw_street_network(options);
  const Terrain terrain = draw_terrain(options);
  const Districts districts = draw_districts(options);
  GlbWriter writer;
  const Materials materials = make_materials(writer, options.seed);
  const ModelLibrary models = make_models(writer, materials, options.seed);
  CitySummary summary;

  const std::vector<DrivingLane> lanes = driving_lanes(network);
  for (int s = 0; s < static_cast<int>(network.streets.size()); ++s)
    add_street(writer, network, s, materials, terrain, options);
  for (const TramTrack& track : tram_tracks(network))
    add_ground(writer, tram_rails(track, materials), "tram track " + network.streets[track.street].name,
               terrain);
  for (int j = 0; j < static_cast<int>(network.junctions.size()); ++j)
    add_junction(writer, network, j, lanes, materials, terrain, options.seed);
  for (int b = 0; b < static_cast<int>(network.blocks.size()); ++b) {
    const CityCharacter& character = districts.character_at(block_middle(network, b));
    const BlockPlan plan = plan_block(network, b, character, options.seed);
    add_block(writer, network, b, plan, materials, terrain, options.seed);
    place(writer, furnish(network, b, plan, models, character, options), terrain, summary);
    summary.buildings += plan.buildings.size();
  }
  Surroundings around = surroundings(network, materials, models, options);
  lift_onto(around.terrain, terrain);
  add_static(writer, around.terrain, around.terrain.name);
  place(writer, around.models, terrain, summary);

  const Traffic traffic = draw_traffic(network, lanes, districts, models, options);
  for (const PlacedModel& vehicle : traffic.vehicles) stand(writer, vehicle, terrain);
  for (const PlacedModel& cyclist : traffic.on_tracks) stand(writer, cyclist, terrain);
  summary.in_traffic += traffic.vehicles.size() + traffic.on_tracks.size();
  for (const DrivingLane& lane : lanes) summary.lane_km += length(lane.points) / 1000;
  summary.style = options.style;
  summary.streets = network.streets.size();
  summary.junctions = network.junctions.size();
  summary.blocks = network.blocks.size();
  summary.lanes = lanes.size();
  summary.triangles = writer.stored_triangles();
  summary.instanced_triangles = writer.instanced_triangles();
  summary.bytes = writer.write(file, {{"cps_city",
                                       {{"style", to_string(options.style)},
                                        {"seed", options.seed},
                                        {"traffic_seed", options.traffic_seed}}},
                                      {"cps_lanes", lanes_as_json(network, lanes, traffic, terrain)}});
  return summary;
}

}  // namespace cps
