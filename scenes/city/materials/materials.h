#pragma once

#include <vector>

#include "scenes/city/geometry/glb_writer.h"

namespace cps::city {

/// A material and the side length of its texture tile.
struct WallMaterial {
  MaterialId material = 0;
  double tile_m = 1;
};

/// All materials of a city. Their colours depend on the seed.
struct Materials {
  MaterialId asphalt, asphalt_patch, tar, paving, kerb, gutter, grass, soil, road_paint, manhole;
  MaterialId cycle_track, rail;
  std::vector<WallMaterial> plaster, brick, concrete;
  std::vector<WallMaterial> curtain_wall;  ///< a tile shows curtain_wall_panels × curtain_wall_storeys panes
  std::vector<WallMaterial> sheet;         ///< ribbed metal; ribs are vertical in the image
  std::vector<MaterialId> gate, container_paint;
  MaterialId fence_wire;
  std::vector<MaterialId> cloth, skin, hair;
  WallMaterial stone;  ///< plinths, cornices
  MaterialId trim;     ///< sills and window surrounds
  MaterialId glass, curtained_glass, shutter, frame_white, frame_dark, door_wood, door_dark, awning;
  std::vector<MaterialId> shop_sign;
  MaterialId roof_tiles, roof_flat, roof_metal;
  std::vector<MaterialId> leaves, fine_leaves, red_leaves, needles;  ///< each in several tints
  MaterialId bark, birch_bark, hedge_core;
  std::vector<MaterialId> car_paint, bus_paint;
  MaterialId bus_display;
  MaterialId car_glass, tyre, rim, car_trim, head_light, tail_light, number_plate;
  MaterialId pole, lamp_glass, sign_red, sign_white, sign_blue, sign_green, sign_yellow, signal_red,
      signal_green, signal_off, wood;
  MaterialId clear_glass;  ///< a transparent pane
  MaterialId cable, mast_wood;
  MaterialId terrain, far_wall, far_roof;
};

Materials make_materials(GlbWriter& writer, std::uint64_t seed);

}  // namespace cps::city
