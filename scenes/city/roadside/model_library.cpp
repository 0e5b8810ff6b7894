#include "scenes/city/roadside/model_library.h"

#include <cmath>

#include "scenes/city/buildings/building.h"
#include "scenes/city/roadside/furniture/boundary.h"
#include "scenes/city/roadside/furniture/bus_stop.h"
#include "scenes/city/roadside/furniture/goods.h"
#include "scenes/city/roadside/overhead/overhead.h"
#include "scenes/city/roadside/person.h"
#include "scenes/city/roadside/tree.h"
#include "scenes/city/roadside/vehicles/bus.h"
#include "scenes/city/roadside/vehicles/lorry.h"
#include "scenes/city/roadside/vehicles/two_wheeler.h"
#include "scenes/city/roadside/vehicles/vehicle.h"

namespace cps::city {
namespace {

Model store(GlbWriter& writer, const Mesh& mesh, double half_length, double half_width,
            ModelKind kind = ModelKind::furniture, double crown_radius = 0) {
  return {kind, writer.add_mesh(mesh), mesh.name, half_length, half_width, crown_radius};
}

void add_trees(ModelLibrary& library, GlbWriter& writer, const Materials& m, std::uint64_t seed) {
  const std::vector<TreeSpecies>& species = tree_species();
  for (std::size_t s = 0; s < species.size(); ++s) {
    std::vector<Model> variants;
    const int count = species[s].cards > 1400 ? 2 : 3;
    for (int v = 0; v < count; ++v) {
      const Stream stream = substream(substream(make_stream(seed, "tree"), s), v);
      const std::vector<MaterialId>& kinds = static_cast<int>(s) == plum              ? m.red_leaves
                                             : species[s].foliage == Foliage::fine    ? m.fine_leaves
                                             : species[s].foliage == Foliage::needles ? m.needles
                                                                                      : m.leaves;
      const MaterialId leaves = kinds[random_below(substream(stream, 1), 0, kinds.size())];
      Mesh mesh = tree(species[s], leaves, species[s].bark == Bark::birch ? m.birch_bark : m.bark, stream);
      mesh.name.append(" ").append(std::to_string(v));
      const double trunk = species[s].trunk_radius_m * 1.5;
      variants.push_back(store(writer, mesh, trunk, trunk, ModelKind::tree, species[s].crown_radius_m + 0.5));
    }
    library.trees.push_back(std::move(variants));
  }
}

/// A model per paint, all sharing one mesh; the other fields are those of `model`.
std::vector<Model> in_paints(GlbWriter& writer, const Mesh& mesh, const std::vector<MaterialId>& paints,
                             Model model) {
  std::vector<Model> painted;
  model.name = mesh.name;
  for (const MaterialId paint : paints) {
    model.mesh = painted.empty() ? writer.add_mesh(mesh)
                                 : writer.add_variant(painted[0].mesh, mesh.name, paints[0], paint);
    painted.push_back(model);
  }
  return painted;
}

void add_vehicles(ModelLibrary& library, GlbWriter& writer, const Materials& m, std::uint64_t seed) {
  const auto sized = [](double half_length, double half_width) {
    return Model{ModelKind::car, 0, {}, half_length, half_width, 0};
  };
  for (const VehicleClass& c : vehicle_classes())
    library.cars.push_back(in_paints(writer, vehicle(c, m, m.car_paint[0]), m.car_paint,
                                     sized(c.length_m / 2 + 0.03, c.width_m / 2 + mirror_m)));
  library.lorries = in_paints(writer, lorry(m, m.car_paint[0]), m.car_paint,
                              sized(lorry_length_m / 2 + 0.03, lorry_width_m / 2 + 0.14));
  library.buses = in_paints(writer, bus(m, m.bus_paint[0]), m.bus_paint,
                            sized(bus_length_m / 2 + 0.03, bus_width_m / 2 + bus_mirror_m));
  for (int i = 0; i < 6; ++i) {
    const Stream stream = substream(make_stream(seed, "two-wheelers"), i);
    const auto add = [&](std::vector<Model>& list, const Mesh& mesh, double half_length, double half_width,
                         ModelKind kind) {
      list.push_back(store(writer, mesh, half_length, half_width, kind));
    };
    if (i < 3)
      add(library.bicycles, bicycle(m, stream), bicycle_half_length_m, bicycle_half_width_m,
          ModelKind::furniture);
    if (i < 3)
      add(library.motorcyclists, motorcyclist(m, stream), motorcycle_half_length_m, motorcycle_half_width_m,
          ModelKind::car);
    add(library.cyclists, cyclist(m, stream), bicycle_half_length_m, bicycle_half_width_m,
        ModelKind::cyclist);
  }
}

void add_boundaries(ModelLibrary& library, GlbWriter& writer, const Materials& m, std::uint64_t seed) {
  const double half = boundary_module_m / 2 - 0.04;  // shorter, so that neighbours may touch
  library.boundaries = {store(writer, hedge(m, boundary_module_m, 1.15, make_stream(seed, "hedge")), half,
                              0.4, ModelKind::boundary),
                        store(writer, picket_fence(m), half, 0.06, ModelKind::boundary),
                        store(writer, mesh_fence(m), half, 0.05, ModelKind::boundary),
                        store(writer, low_wall(m), half, 0.15, ModelKind::boundary),
                        store(writer, high_wall(m), half, 0.12, ModelKind::boundary)};
}

void add_goods(ModelLibrary& library, GlbWriter& writer, const Materials& m) {
  const int first = writer.add_mesh(container(m, m.container_paint[0]));
  for (std::size_t p = 0; p < m.container_paint.size(); ++p)
    library.goods.push_back(
        {ModelKind::goods,
         p == 0 ? first : writer.add_variant(first, "container", m.container_paint[0], m.container_paint[p]),
         "container", 3.05, 1.24, 0});
  library.goods.push_back(store(writer, container_stack(m), 3.05, 1.24, ModelKind::goods));
  library.goods.push_back(store(writer, pallets(m), 1.3, 0.65, ModelKind::goods));
  library.goods.push_back(store(writer, silo(m), 1.7, 1.7, ModelKind::goods));
}

void add_far_houses(ModelLibrary& library, GlbWriter& writer, const Materials& m, std::uint64_t seed) {
  for (int i = 0; i < 7; ++i) {
    Draws draws{substream(make_stream(seed, "far house"), i)};
    const double width = draws.uniform(10, i < 4 ? 16 : 30), depth = draws.uniform(9, 13);
    BuildingPlan plan;
    plan.footprint = make_footprint({{-width / 2, -depth / 2}, {width / 2, -depth / 2}}, depth);
    plan.storeys = i < 4 ? draws.integer(2, 3) : draws.integer(5, 11);
    plan.roof = i < 4 ? (draws.chance(0.5) ? RoofKind::gable : RoofKind::hip) : RoofKind::flat;
    plan.distant = true;
    Mesh mesh = building(plan, m, substream(draws.stream, 1)).mesh;
    mesh.name = "far house " + std::to_string(i);
    library.far_houses.push_back(store(writer, mesh, width / 2, depth / 2, ModelKind::house));
  }
}

}  // namespace

const Model& draw_car(Draws& draws, const ModelLibrary& models) {
  double pick = draws.uniform(0, 1);
  std::size_t kind = 0;
  while (kind + 1 < models.cars.size() && pick > vehicle_classes()[kind].share)
    pick -= vehicle_classes()[kind++].share;
  return draws.one_of(models.cars[kind]);
}

ModelLibrary make_models(GlbWriter& writer, const Materials& m, std::uint64_t seed) {
  ModelLibrary library;
  add_trees(library, writer, m, seed);
  add_vehicles(library, writer, m, seed);
  add_far_houses(library, writer, m, seed);
  library.lamp = store(writer, street_lamp(m, 8.0, 1.2), 0.1, 0.1);
  library.tall_lamp = store(writer, street_lamp(m, 9.8, 2.0), 0.1, 0.1);
  library.bollard = store(writer, bollard(m), 0.06, 0.06);
  library.bin = store(writer, bin(m), 0.4, 0.2);
  library.bench = store(writer, bench(m), 0.35, 0.9);
  library.switch_box = store(writer, switch_box(m), 0.2, 0.62);
  library.telegraph_mast = store(writer, telegraph_mast(m), 0.14, 0.14);
  library.span_mast = store(writer, span_mast(m), 0.11, 0.11);
  library.bus_shelter = store(writer, bus_shelter(m), shelter_half_depth_m, shelter_half_length_m);
  library.bus_stop_sign = store(writer, bus_stop_sign(m), 0.18, 0.1);
  add_boundaries(library, writer, m, seed);
  add_goods(library, writer, m);
  for (int i = 0; i < 12; ++i)
    library.people.push_back(
        store(writer, person(m, substream(make_stream(seed, "person"), i)), 0.4, 0.35, ModelKind::person));
  for (const SignKind kind : {SignKind::no_stopping, SignKind::yield, SignKind::priority, SignKind::parking,
                              SignKind::crossing, SignKind::speed})
    library.signs.push_back(store(writer, traffic_sign(m, kind), 0.3, 0.06));
  library.traffic_light_red = store(writer, traffic_light(m, false), 0.15, 0.3);
  library.traffic_light_green = store(writer, traffic_light(m, true), 0.15, 0.3);
  return library;
}

Polygon PlacedModel::footprint() const {
  const Vec2 along(std::cos(heading_rad), std::sin(heading_rad));
  const Vec2 a = along * (model->half_length * scale), b = left_of(along) * (model->half_width * scale);
  return {position - a - b, position + a - b, position + a + b, position - a + b};
}

}  // namespace cps::city
