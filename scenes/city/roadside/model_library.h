#pragma once

#include "scenes/city/draws.h"
#include "scenes/city/materials/materials.h"
#include "scenes/city/roadside/furniture/street_furniture.h"

/// Models that appear more than once: each is stored as one mesh and placed by many nodes.
namespace cps::city {

enum class ModelKind { tree, boundary, person, car, cyclist, furniture, goods, house };

struct Model {
  ModelKind kind = ModelKind::furniture;
  int mesh = 0;
  std::string name;
  double half_length = 0,
         half_width = 0;    ///< of the ground it covers below head height, along and across its +x
  double crown_radius = 0;  ///< of trees
};

struct ModelLibrary {
  std::vector<std::vector<Model>> trees;  ///< [species, as tree_species()][variant]
  std::vector<std::vector<Model>> cars;   ///< [class, as vehicle_classes()][paint]
  Model lamp, tall_lamp, bollard, bin, bench, switch_box;
  std::vector<Model> boundaries;  ///< one module per BoundaryKind
  std::vector<Model> goods;       ///< containers, silos
  std::vector<Model> signs;       ///< by SignKind
  Model telegraph_mast, span_mast, bus_shelter, bus_stop_sign;
  Model traffic_light_red, traffic_light_green;
  std::vector<Model> far_houses, people;
  std::vector<Model> lorries, buses, bicycles, cyclists, motorcyclists;
};

/// A random car; its class follows the classes' shares.
const Model& draw_car(Draws& draws, const ModelLibrary& models);

ModelLibrary make_models(GlbWriter& writer, const Materials& materials, std::uint64_t seed);

/// A model placed in the city.
struct PlacedModel {
  const Model* model = nullptr;
  Vec2 position;
  double height = 0, heading_rad = 0, scale = 1;

  /// The rectangle of ground it covers.
  Polygon footprint() const;
};

}  // namespace cps::city
