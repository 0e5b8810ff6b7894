#include "scenes/city/city.h"

#include <cstdio>
#include <stdexcept>

#include "scenes/city/blocks/block_plan.h"
#include "scenes/city/geometry/glb_writer.h"
#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/materials.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/roadside/model_library.h"
#include "scenes/city/roadside/roadside.h"
#include "scenes/city/roadside/surroundings.h"
#include "scenes/city/roadside/tree.h"
#include "scenes/city/streets/driving_lanes.h"
#include "scenes/city/streets/road_markings.h"
#include "scenes/city/streets/road_surface.h"
#include "scenes/city/streets/street_network.h"

namespace cps {

using namespace city;

bool CityOptions::is_valid(std::string* why) const {
  const auto fail = [&](const char* reason) {
    if (why) *why = reason;
    return false;
  };
  if (!(extent_m >= 300 && extent_m <= 1200)) return fail("extent_m: choose 300 … 1200 metres");
  if (!(tree_density >= 0 && tree_density <= 3)) return fail("tree_density: choose 0 … 3");
  if (!(parked_cars >= 0 && parked_cars <= 2)) return fail("parked_cars: choose 0 … 2");
  return true;
}

std::string CitySummary::brief() const {
  char text[512];
  std::snprintf(text, sizeof text,
                "%s: %zu streets, %zu junctions, %zu blocks, %zu buildings, %zu trees, %zu cars, %zu people, "
                "%zu pieces of "
                "street furniture\n"
                "%zu lanes, %.1f km in all\n"
                "%.2f M triangles (%.2f M with instances), %.1f MB",
                to_string(style).c_str(), streets, junctions, blocks, buildings, trees, cars, people,
                furniture, lanes, lane_km, triangles * 1e-6, instanced_triangles * 1e-6, bytes * 1e-6);
  return text;
}

namespace {

void add_static(GlbWriter& writer, Mesh mesh, const std::string& name) {
  if (mesh.empty()) return;
  mesh.name = name;
  writer.add_node(name, writer.add_mesh(mesh));
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

void add_block(GlbWriter& writer, const StreetNetwork& network, int index, const BlockPlan& plan,
               const Materials& materials, std::uint64_t seed) {
  const std::string name = "block " + std::to_string(index);
  Mesh ground = pavement(network, network.blocks[index], plan.pavement_m, materials, seed);
  const auto weather = [stream = make_stream(seed, "weathering")](const Vec2& p) {
    return weathering(stream, p);
  };
  const WallMaterial surface = ground_material(materials, plan.ground);
  add_floor(ground.surfaces[surface.material], plan.border.points, kerb_height_m, surface.tile_m, weather);
  for (const Pad& pad : plan.pads) {
    const WallMaterial cover = ground_material(materials, pad.kind);
    add_floor(ground.surfaces[cover.material], pad.outline, kerb_height_m + pad_rise_m, cover.tile_m,
              weather);
  }
  add_static(writer, std::move(ground), name);
  const Stream buildings = substream(make_stream(seed, "building"), index);
  for (std::size_t k = 0; k < plan.buildings.size(); ++k)
    add_static(writer, building(plan.buildings[k], materials, substream(buildings, k)),
               name + " building " + std::to_string(k));
}

void place(GlbWriter& writer, const std::vector<PlacedModel>& placed, CitySummary& summary) {
  for (const PlacedModel& p : placed) {
    switch (p.model->kind) {
      case ModelKind::tree:
        ++summary.trees;
        break;
      case ModelKind::car:
        ++summary.cars;
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
    writer.add_node(p.model->name, p.model->mesh, {lift(p.position, p.height), p.heading_rad, p.scale});
  }
}

nlohmann::ordered_json lanes_as_json(const StreetNetwork& network, const std::vector<DrivingLane>& lanes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const DrivingLane& lane : lanes) {
    nlohmann::ordered_json points = nlohmann::ordered_json::array();
    for (const Vec2& p : lane.points)
      points.push_back({std::round(p.x() * 1e3) / 1e3, 0.0, std::round(-p.y() * 1e3) / 1e3});
    list.push_back({{"street", network.streets[lane.street].name},
                    {"width_m", std::round(lane.width_m * 1e3) / 1e3},
                    {"points", std::move(points)},
                    {"next", lane.next}});
  }
  return list;
}

}  // namespace

CitySummary write_city(const CityOptions& options, const std::filesystem::path& file) {
  if (std::string why; !options.is_valid(&why)) throw std::runtime_error("city: " + why);
  const StreetNetwork network = draw_street_network(options);
  const Districts districts = draw_districts(options);
  GlbWriter writer;
  const Materials materials = make_materials(writer, options.seed);
  const ModelLibrary models = make_models(writer, materials, options.seed);
  CitySummary summary;

  for (int s = 0; s < static_cast<int>(network.streets.size()); ++s) {
    add_static(writer, carriageway(network, s, materials, options.seed), "street " + network.streets[s].name);
    add_static(writer, road_markings(network, s, materials, options.seed),
               "markings " + network.streets[s].name);
  }
  for (int j = 0; j < static_cast<int>(network.junctions.size()); ++j)
    add_static(writer, junction_floor(network, j, materials, options.seed), "junction " + std::to_string(j));
  for (int b = 0; b < static_cast<int>(network.blocks.size()); ++b) {
    const CityCharacter& character = districts.character_at(block_middle(network, b));
    const BlockPlan plan = plan_block(network, b, character, options.seed);
    add_block(writer, network, b, plan, materials, options.seed);
    place(writer, furnish(network, b, plan, models, character, options), summary);
    summary.buildings += plan.buildings.size();
  }
  const Surroundings around = surroundings(network, materials, models, options);
  add_static(writer, around.terrain, around.terrain.name);
  place(writer, around.models, summary);

  const std::vector<DrivingLane> lanes = driving_lanes(network);
  for (const DrivingLane& lane : lanes) summary.lane_km += length(lane.points) / 1000;
  summary.style = options.style;
  summary.streets = network.streets.size();
  summary.junctions = network.junctions.size();
  summary.blocks = network.blocks.size();
  summary.lanes = lanes.size();
  summary.triangles = writer.stored_triangles();
  summary.instanced_triangles = writer.instanced_triangles();
  summary.bytes =
      writer.write(file, {{"cps_city", {{"style", to_string(options.style)}, {"seed", options.seed}}},
                          {"cps_lanes", lanes_as_json(network, lanes)}});
  return summary;
}

}  // namespace cps
