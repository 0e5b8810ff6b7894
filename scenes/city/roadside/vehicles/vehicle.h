#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

/// The shape of a car body: a side view (stations along x, the front at +x, metres from the middle) and how
/// it narrows.
struct VehicleClass {
  const char* name;
  double share;  ///< of the cars in a street; together 1
  double length_m, width_m, height_m;
  double wheel_radius_m, front_axle_m, rear_axle_m;  ///< axles: x
  double bonnet_height_m, belt_height_m, boot_height_m;
  double windscreen_foot_m, windscreen_top_m, rear_top_m, rear_foot_m;  ///< x of the glasshouse's corners
  bool panel_van = false;                                               ///< no windows behind the front doors
};

const std::vector<VehicleClass>& vehicle_classes();

/// How far the mirrors stand out beyond the body's width.
inline constexpr double mirror_m = 0.17;

/// A parked car, wheels on the ground around the origin, looking along +x; `paint` is its body's material.
Mesh vehicle(const VehicleClass& vehicle_class, const Materials& materials, MaterialId paint);

}  // namespace cps::city
