#include "scenes/city/materials/materials.h"

#include "scenes/city/draws.h"
#include "scenes/city/materials/textures.h"

namespace cps::city {
namespace {

using Color = std::array<double, 3>;

MaterialDescription textured(GlbWriter& writer, const std::string& name, const TextureSet& set,
                             const Color& tint = {1, 1, 1}) {
  MaterialDescription m;
  m.name = name;
  m.base_color = tint;
  m.metallic = 1;  // factors multiply the texture
  m.base_color_texture = writer.add_texture(name + "_color", set.base_color);
  m.normal_texture = writer.add_texture(name + "_normal", set.normal);
  m.metallic_roughness_texture = writer.add_texture(name + "_roughness", set.metallic_roughness);
  return m;
}

MaterialDescription tinted(MaterialDescription m, const std::string& name, const Color& tint) {
  m.name = name;
  m.base_color = tint;
  return m;
}

MaterialDescription plain(const std::string& name, const Color& color, double roughness,
                          double metallic = 0) {
  MaterialDescription m;
  m.name = name;
  m.base_color = color;
  m.roughness = roughness;
  m.metallic = metallic;
  return m;
}

void add_ground(GlbWriter& writer, Materials& m, std::uint64_t seed) {
  const MaterialDescription asphalt =
      textured(writer, "asphalt", asphalt_texture(make_stream(seed, "asphalt")));
  m.asphalt = writer.add_material(asphalt);
  m.cycle_track = writer.add_material(tinted(asphalt, "cycle_track", {1.0, 0.36, 0.26}));
  m.rail = writer.add_material(plain("rail", {0.36, 0.34, 0.32}, 0.45, 0.9));
  m.asphalt_patch = writer.add_material(tinted(asphalt, "asphalt_patch", {0.62, 0.62, 0.64}));
  m.tar = writer.add_material(plain("tar", {0.022, 0.022, 0.024}, 0.55));
  m.paving = writer.add_material(textured(writer, "paving", paving_texture(make_stream(seed, "paving"))));
  const MaterialDescription kerb = textured(writer, "kerb", kerb_texture(make_stream(seed, "kerb")));
  m.kerb = writer.add_material(kerb);
  m.gutter = writer.add_material(tinted(kerb, "gutter", {0.55, 0.55, 0.55}));
  const MaterialDescription grass = textured(writer, "grass", grass_texture(make_stream(seed, "grass")));
  m.grass = writer.add_material(grass);
  m.soil = writer.add_material(tinted(grass, "soil", {0.95, 0.58, 0.6}));
  m.road_paint = writer.add_material(
      textured(writer, "road_paint", road_paint_texture(make_stream(seed, "road paint"))));
  m.manhole = writer.add_material(plain("manhole", {0.06, 0.06, 0.065}, 0.5, 0.7));
  m.terrain = writer.add_material(plain("terrain", {0.105, 0.135, 0.085}, 1));
}

void add_walls(GlbWriter& writer, Materials& m, std::uint64_t seed) {
  Draws draws{make_stream(seed, "wall colours")};
  const MaterialDescription plaster =
      textured(writer, "plaster", plaster_texture(make_stream(seed, "plaster")));
  const std::vector<Color> tints{{0.95, 0.93, 0.88}, {0.93, 0.86, 0.66}, {0.88, 0.72, 0.42},
                                 {0.80, 0.52, 0.38}, {0.66, 0.72, 0.62}, {0.62, 0.68, 0.76},
                                 {0.86, 0.78, 0.70}, {0.70, 0.66, 0.60}, {0.55, 0.52, 0.48},
                                 {0.90, 0.66, 0.52}, {0.97, 0.97, 0.96}};
  const std::size_t first = draws.integer(0, static_cast<int>(tints.size()) - 1);
  for (int i = 0; i < 6; ++i) {  // every other tint of the list, so that a city's plasters differ clearly
    Color tint = tints[(first + 2 * i) % tints.size()];
    for (double& c : tint) c = std::min(1.0, c * draws.uniform(0.9, 1.05));
    m.plaster.push_back(
        {writer.add_material(tinted(plaster, "plaster_" + std::to_string(i), tint)), plaster_tile_m});
  }
  m.stone = {writer.add_material(tinted(plaster, "stone", {0.62, 0.58, 0.52})), plaster_tile_m};
  m.trim = writer.add_material(plain("trim", {0.50, 0.47, 0.42}, 0.85));
  const MaterialDescription brick = textured(writer, "brick", brick_texture(make_stream(seed, "brick")));
  m.brick.push_back({writer.add_material(brick), brick_tile_m});
  m.brick.push_back({writer.add_material(tinted(brick, "brick_dark", {0.6, 0.62, 0.66})), brick_tile_m});
  const MaterialDescription concrete =
      textured(writer, "concrete", concrete_texture(make_stream(seed, "concrete")));
  m.concrete.push_back(
      {writer.add_material(tinted(concrete, "concrete", {0.62, 0.62, 0.62})), concrete_tile_m});
  m.concrete.push_back(
      {writer.add_material(tinted(concrete, "concrete_light", {1, 0.97, 0.92})), concrete_tile_m});
  m.roof_tiles =
      writer.add_material(textured(writer, "roof_tiles", roof_tile_texture(make_stream(seed, "roof"))));
  m.roof_flat =
      writer.add_material(textured(writer, "roof_flat", flat_roof_texture(make_stream(seed, "flat roof"))));
  m.roof_metal = writer.add_material(plain("roof_metal", {0.30, 0.33, 0.34}, 0.4, 0.6));
  m.far_wall = writer.add_material(plain("far_wall", {0.50, 0.50, 0.50}, 0.9));
  m.far_roof = writer.add_material(plain("far_roof", {0.30, 0.24, 0.22}, 0.9));
}

void add_works(GlbWriter& writer, Materials& m, std::uint64_t seed) {
  const MaterialDescription curtain =
      textured(writer, "curtain_wall", curtain_wall_texture(make_stream(seed, "curtain wall")));
  for (const Color& tint :
       {Color{0.50, 0.60, 0.66}, {0.42, 0.55, 0.50}, {0.62, 0.50, 0.38}, {0.34, 0.36, 0.40}})
    m.curtain_wall.push_back(
        {writer.add_material(tinted(curtain, "curtain_wall_" + std::to_string(m.curtain_wall.size()), tint)),
         curtain_wall_tile_m});
  const MaterialDescription sheet = textured(writer, "sheet", sheet_texture(make_stream(seed, "sheet")));
  for (const Color& tint : {Color{0.75, 0.76, 0.76},
                            {0.42, 0.46, 0.50},
                            {0.28, 0.38, 0.50},
                            {0.70, 0.66, 0.55},
                            {0.30, 0.40, 0.32},
                            {0.55, 0.22, 0.16}})
    m.sheet.push_back(
        {writer.add_material(tinted(sheet, "sheet_" + std::to_string(m.sheet.size()), tint)), sheet_tile_m});
  for (const Color& tint :
       {Color{0.30, 0.07, 0.04}, {0.04, 0.12, 0.28}, {0.08, 0.24, 0.14}, {0.5, 0.5, 0.48}})
    m.container_paint.push_back(writer.add_material(
        tinted(sheet, "container_paint_" + std::to_string(m.container_paint.size()), tint)));
  m.fence_wire = writer.add_material(plain("fence_wire", {0.10, 0.16, 0.12}, 0.5, 0.2));
  for (const Color& tint :
       {Color{0.72, 0.72, 0.70}, {0.12, 0.20, 0.34}, {0.28, 0.30, 0.31}, {0.30, 0.16, 0.08}})
    m.gate.push_back(writer.add_material(plain("gate_" + std::to_string(m.gate.size()), tint, 0.5)));
}

void add_openings(GlbWriter& writer, Materials& m, std::uint64_t seed) {
  Draws draws{make_stream(seed, "joinery colours")};
  m.glass = writer.add_material(plain("glass", {0.018, 0.022, 0.026}, 0.04));
  m.curtained_glass = writer.add_material(plain("curtained_glass", {0.32, 0.31, 0.29}, 0.12));
  m.shutter = writer.add_material(plain("shutter", {0.55, 0.53, 0.48}, 0.6));
  m.frame_white = writer.add_material(plain("frame_white", {0.80, 0.80, 0.78}, 0.45));
  m.frame_dark = writer.add_material(plain("frame_dark", {0.07, 0.065, 0.06}, 0.4));
  m.door_wood = writer.add_material(plain("door_wood", {draws.uniform(0.10, 0.2), 0.07, 0.04}, 0.5));
  m.door_dark = writer.add_material(plain("door_dark", {0.03, draws.uniform(0.04, 0.1), 0.05}, 0.4));
  m.awning =
      writer.add_material(plain("awning", {draws.uniform(0.2, 0.6), draws.uniform(0.05, 0.4), 0.1}, 0.9));
  for (const Color& color : {Color{0.45, 0.03, 0.03},
                             {0.02, 0.12, 0.35},
                             {0.75, 0.73, 0.68},
                             {0.04, 0.22, 0.09},
                             {0.75, 0.45, 0.03},
                             {0.03, 0.03, 0.035}})
    m.shop_sign.push_back(
        writer.add_material(plain("shop_sign_" + std::to_string(m.shop_sign.size()), color, 0.4)));
}

void add_plants(GlbWriter& writer, Materials& m, std::uint64_t seed) {
  const auto foliage = [&](const std::string& name, const TextureSet& set) {
    MaterialDescription d = textured(writer, name, set);
    d.alpha_mask = d.double_sided = true;
    return d;
  };
  const MaterialDescription broad = foliage("leaves", leaf_texture(make_stream(seed, "leaves")));
  m.leaves.push_back(writer.add_material(tinted(broad, "leaves", {0.74, 0.80, 0.76})));
  m.leaves.push_back(writer.add_material(tinted(broad, "leaves_dark", {0.45, 0.56, 0.52})));
  m.leaves.push_back(writer.add_material(tinted(broad, "leaves_light", {0.95, 0.92, 0.62})));
  const MaterialDescription fine =
      foliage("fine_leaves", fine_leaf_texture(make_stream(seed, "fine leaves")));
  m.fine_leaves.push_back(writer.add_material(tinted(fine, "fine_leaves", {0.80, 0.88, 0.72})));
  m.fine_leaves.push_back(writer.add_material(tinted(fine, "fine_leaves_dark", {0.55, 0.66, 0.55})));
  m.red_leaves.push_back(writer.add_material(tinted(fine, "fine_leaves_red", {0.55, 0.20, 0.42})));
  const MaterialDescription needles = foliage("needles", needle_texture(make_stream(seed, "needles")));
  m.needles.push_back(writer.add_material(needles));
  m.needles.push_back(writer.add_material(tinted(needles, "needles_blue", {0.8, 0.92, 1})));
  m.bark = writer.add_material(textured(writer, "bark", bark_texture(make_stream(seed, "bark"))));
  m.birch_bark = writer.add_material(
      textured(writer, "birch_bark", birch_bark_texture(make_stream(seed, "birch bark"))));
  m.hedge_core = writer.add_material(plain("hedge_core", {0.03, 0.05, 0.015}, 1));
}

void add_vehicles_and_furniture(GlbWriter& writer, Materials& m) {
  const std::vector<Color> paints{{0.01, 0.01, 0.012}, {0.55, 0.56, 0.57}, {0.80, 0.80, 0.79},
                                  {0.12, 0.125, 0.13}, {0.30, 0.02, 0.02}, {0.02, 0.05, 0.18},
                                  {0.06, 0.09, 0.07},  {0.30, 0.26, 0.20}, {0.50, 0.025, 0.02},
                                  {0.03, 0.14, 0.42},  {0.22, 0.24, 0.26}, {0.42, 0.16, 0.03}};
  for (const Color& color : paints)
    m.car_paint.push_back(
        writer.add_material(plain("car_paint_" + std::to_string(m.car_paint.size()), color, 0.22)));
  for (const Color& color : {Color{0.66, 0.42, 0.02},
                             {0.52, 0.03, 0.03},
                             {0.74, 0.74, 0.72},
                             {0.05, 0.18, 0.42},
                             {0.10, 0.33, 0.14}})
    m.bus_paint.push_back(
        writer.add_material(plain("bus_paint_" + std::to_string(m.bus_paint.size()), color, 0.25)));
  m.bus_display = writer.add_material(plain("bus_display", {0.55, 0.28, 0.01}, 0.4));
  m.car_glass = writer.add_material(plain("car_glass", {0.012, 0.014, 0.015}, 0.03));
  m.tyre = writer.add_material(plain("tyre", {0.018, 0.018, 0.018}, 0.9));
  m.rim = writer.add_material(plain("rim", {0.55, 0.55, 0.56}, 0.3, 0.9));
  m.car_trim = writer.add_material(plain("car_trim", {0.03, 0.03, 0.03}, 0.6));
  m.head_light = writer.add_material(plain("head_light", {0.7, 0.72, 0.74}, 0.08, 0.3));
  m.tail_light = writer.add_material(plain("tail_light", {0.35, 0.01, 0.01}, 0.15));
  m.number_plate = writer.add_material(plain("number_plate", {0.78, 0.78, 0.76}, 0.5));
  m.pole = writer.add_material(plain("pole", {0.30, 0.32, 0.32}, 0.45, 0.7));
  m.lamp_glass = writer.add_material(plain("lamp_glass", {0.75, 0.75, 0.72}, 0.2));
  m.sign_red = writer.add_material(plain("sign_red", {0.55, 0.02, 0.02}, 0.4));
  m.sign_white = writer.add_material(plain("sign_white", {0.82, 0.82, 0.82}, 0.4));
  m.sign_blue = writer.add_material(plain("sign_blue", {0.01, 0.10, 0.42}, 0.4));
  m.sign_green = writer.add_material(plain("sign_green", {0.02, 0.22, 0.09}, 0.4));
  m.sign_yellow = writer.add_material(plain("sign_yellow", {0.72, 0.52, 0.03}, 0.4));
  m.signal_red = writer.add_material(plain("signal_red", {0.6, 0.02, 0.01}, 0.3));
  m.signal_green = writer.add_material(plain("signal_green", {0.01, 0.4, 0.2}, 0.3));
  m.signal_off = writer.add_material(plain("signal_off", {0.02, 0.02, 0.02}, 0.3));
  MaterialDescription pane = plain("clear_glass", {0.86, 0.90, 0.88}, 0.0);
  pane.transmission = 0.95;
  pane.double_sided = true;
  m.clear_glass = writer.add_material(pane);
  m.cable = writer.add_material(plain("cable", {0.02, 0.02, 0.02}, 0.6));
  m.mast_wood = writer.add_material(plain("mast_wood", {0.17, 0.14, 0.11}, 0.9));
  m.wood = writer.add_material(plain("wood", {0.22, 0.13, 0.07}, 0.7));
}

void add_people(GlbWriter& writer, Materials& m) {
  const auto add = [&](std::vector<MaterialId>& kind, const std::string& name,
                       const std::vector<Color>& colors, double roughness) {
    for (const Color& color : colors)
      kind.push_back(writer.add_material(plain(name + "_" + std::to_string(kind.size()), color, roughness)));
  };
  add(m.cloth, "cloth",
      {{0.02, 0.025, 0.05},
       {0.03, 0.03, 0.03},
       {0.25, 0.04, 0.04},
       {0.12, 0.12, 0.13},
       {0.40, 0.36, 0.28},
       {0.05, 0.13, 0.08},
       {0.06, 0.12, 0.30},
       {0.55, 0.54, 0.52}},
      0.95);
  add(m.skin, "skin", {{0.50, 0.30, 0.22}, {0.32, 0.18, 0.12}, {0.14, 0.07, 0.045}}, 0.6);
  add(m.hair, "hair", {{0.02, 0.015, 0.012}, {0.10, 0.055, 0.025}, {0.30, 0.20, 0.10}, {0.32, 0.32, 0.32}},
      0.7);
}

}  // namespace

Materials make_materials(GlbWriter& writer, std::uint64_t seed) {
  Materials m;
  add_ground(writer, m, seed);
  add_walls(writer, m, seed);
  add_works(writer, m, seed);
  add_openings(writer, m, seed);
  add_plants(writer, m, seed);
  add_vehicles_and_furniture(writer, m);
  add_people(writer, m);
  return m;
}

}  // namespace cps::city
