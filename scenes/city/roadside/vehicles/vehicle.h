#pragma once

#include "scenes/city/materials/materials.h"

namespace cps::city {

/// The shape of a car body, by its side view: x from the middle, front at +x, metres.
struct VehicleClass {
  const char* name;
  double share;  ///< share of all cars; the shares sum to 1
  double length_m, width_m, height_m;
  double wheel_radius_m, front_axle_m, rear_axle_m;  ///< axles: x
  double bonnet_height_m, belt_height_m, boot_height_m;
  double windscreen_foot_m, windscreen_top_m, rear_top_m, rear_foot_m;  ///< x of the glasshouse's corners
  bool panel_van = false;                                               ///< no windows behind the front seats
};

const std::vector<VehicleClass>& vehicle_classes();

/// How far each mirror projects beyond the body.
inline constexpr double mirror_m = 0.17;

/// A car centred at the origin, wheels on the ground, facing +x. `paint` is the body's material.
Mesh vehicle(const VehicleClass& vehicle_class, const Materials& materials, MaterialId paint);

}  // namespace cps::city
