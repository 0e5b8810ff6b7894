#pragma once

#include <array>
#include <cstdint>

/// The classes of Cityscapes (M. Cordts et al., "The Cityscapes dataset for semantic urban scene
/// understanding", CVPR 2016, table 8), by their ids in its label images.
namespace cps::cityscapes {

enum Id : std::uint16_t {
  unlabeled,
  ego_vehicle,
  rectification_border,
  out_of_roi,
  fixed_thing,    ///< "static"
  movable_thing,  ///< "dynamic"
  ground,
  road,
  sidewalk,
  parking,
  rail_track,
  building,
  wall,
  fence,
  guard_rail,
  bridge,
  tunnel,
  pole,
  pole_group,
  traffic_light,
  traffic_sign,
  vegetation,
  terrain,
  sky,
  person,
  rider,
  car,
  truck,
  bus,
  caravan,
  trailer,
  train,
  motorcycle,
  bicycle
};

/// Its names of the classes, by id.
inline constexpr std::array<const char*, bicycle + 1> names = {
    "unlabeled",  "ego vehicle",   "rectification border",
    "out of roi", "static",        "dynamic",
    "ground",     "road",          "sidewalk",
    "parking",    "rail track",    "building",
    "wall",       "fence",         "guard rail",
    "bridge",     "tunnel",        "pole",
    "polegroup",  "traffic light", "traffic sign",
    "vegetation", "terrain",       "sky",
    "person",     "rider",         "car",
    "truck",      "bus",           "caravan",
    "trailer",    "train",         "motorcycle",
    "bicycle"};

/// Whether it counts the things of a class (hasInstances).
constexpr bool has_instances(Id id) {
  return id >= person;
}

}  // namespace cps::cityscapes
