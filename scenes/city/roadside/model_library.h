#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/materials/materials.h"
#include "scenes/city/roadside/furniture/street_furniture.h"

/// Everything that stands in the city more than once: stored as one mesh, placed by many nodes.
namespace cps::city {

enum class ModelKind { tree, boundary, person, car, cyclist, furniture, goods, house };

struct Model {
  ModelKind kind = ModelKind::furniture;
  int mesh = 0;
  std::string name;
  double half_length = 0,
         half_width = 0;    ///< of the ground it needs below head height, along and across its +x
  double crown_radius = 0;  ///< trees: what it needs above
};

struct ModelLibrary {
  std::vector<std::vector<Model>> trees;  ///< [species, in tree_species()'s order][variant]
  std::vector<std::vector<Model>> cars;   ///< [class, in vehicle_classes()'s order][paint]
  Model lamp, tall_lamp, bollard, bin, bench, switch_box;
  std::vector<Model> boundaries;  ///< one module each, by BoundaryKind
  std::vector<Model> goods;       ///< containers, silos
  std::vector<Model> signs;       ///< by SignKind
  Model telegraph_mast, span_mast, bus_shelter, bus_stop_sign;
  Model traffic_light_red, traffic_light_green;
  std::vector<Model> far_houses, people;
  std::vector<Model> lorries, buses, bicycles, cyclists, motorcyclists;
};

/// A car of any paint, its class by the classes' shares.
const Model& draw_car(Draws& draws, const ModelLibrary& models);

ModelLibrary make_models(GlbWriter& writer, const Materials& materials, std::uint64_t seed);

/// One of them, standing.
struct PlacedModel {
  const Model* model = nullptr;
  Vec2 position;
  double height = 0, heading_rad = 0, scale = 1;

  /// The ground it covers.
  Polygon footprint() const;
};

}  // namespace cps::city
