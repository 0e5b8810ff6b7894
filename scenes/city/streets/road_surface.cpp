#include "scenes/city/streets/road_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/city/draws.h"
#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/textures.h"

namespace cps::city {
namespace {

void add_asphalt_vertex(Surface& surface, const Vec2& p, double light) {
  surface.positions.push_back(lift(p, 0).cast<float>());
  surface.normals.emplace_back(0.f, 1.f, 0.f);
  surface.uvs.emplace_back(Vec2(p.x() / asphalt_tile_m, -p.y() / asphalt_tile_m).cast<float>());
  surface.colors.push_back(gray_color(light));
}

/// How much darker the asphalt is where wheels run: 0 … 1, by the offset from the centre line.
double wheel_track(const StreetProfile& profile, double left_m) {
  double track = 0;
  const auto add_lane = [&](double middle) {
    for (const double wheel : {-0.8, 0.8}) track += std::exp(-std::pow((left_m - middle - wheel) / 0.32, 2));
  };
  for (int lane = 0; lane < profile.lanes_forward; ++lane) add_lane(profile.forward_lane_offset(lane));
  for (int lane = 0; lane < profile.lanes_backward; ++lane) add_lane(profile.backward_lane_offset(lane));
  return track;
}

void add_lane_asphalt(Surface& surface, const Polyline& centre, const StreetProfile& profile,
                      Stream weather) {
  const Polyline line = subdivided(centre, 2.5);
  const Polyline left = offset(line, profile.half_width()), right = offset(line, -profile.half_width());
  const int columns = std::max(2, static_cast<int>(std::ceil(2 * profile.half_width() / 0.42)));
  const auto first = static_cast<std::uint32_t>(surface.positions.size());
  for (std::size_t i = 0; i < line.size(); ++i)
    for (int c = 0; c <= columns; ++c) {
      const double t = static_cast<double>(c) / columns;
      const Vec2 p = right[i] + (left[i] - right[i]) * t;
      const double offset_m = (2 * t - 1) * profile.half_width();
      add_asphalt_vertex(surface, p, weathering(weather, p) - 0.09 * wheel_track(profile, offset_m));
    }
  const std::uint32_t row = columns + 1;
  for (std::uint32_t i = 0; i + 1 < line.size(); ++i)
    for (std::uint32_t c = 0; c + 1 < row; ++c) {
      const std::uint32_t a = first + i * row + c, b = a + row;
      surface.indices.insert(surface.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
}

void add_disc(Surface& surface, const Vec2& centre, double radius, double height) {
  std::vector<Vertex> rim(24);
  for (int i = 0; i < 24; ++i) {
    const double a = 2 * std::numbers::pi * i / 24;
    rim[i] = {lift(centre + Vec2(std::cos(a), std::sin(a)) * radius, height)};
  }
  add_polygon(surface, rim);
}

/// A crack somebody filled with tar: a wandering seam along (or across) the road.
void add_seam(Surface& surface, const Polyline& centre, double from, double to, double left_m, double limit,
              Draws& draws) {
  Polyline seam;
  double wander = left_m;
  for (double s = from; s <= to; s += 0.6) {
    wander = std::clamp(wander + draws.uniform(-0.12, 0.12), -limit, limit);
    const Station at = station_at(centre, s);
    seam.push_back(at.point + left_of(at.direction) * wander);
  }
  if (seam.size() > 2) add_stripe(surface, seam, draws.uniform(0.03, 0.06), seam_height_m, 1);
}

void add_wear(Mesh& mesh, const Polyline& centre, const StreetProfile& profile, const Materials& m,
              double wear, Draws& draws) {
  const double total = length(centre), half = profile.half_width();
  const int patches = static_cast<int>(total / 30 * wear * draws.uniform(0.3, 1.8));
  for (int i = 0; i < patches; ++i) {
    const double l = draws.uniform(1.0, 7), w = draws.uniform(0.7, 2.4);
    const double s = draws.uniform(1, std::max(1.1, total - l - 1));
    const double left = draws.uniform(-half + w / 2 + 0.5, half - w / 2 - 0.5);
    if (s + l < total - 0.5)
      add_stripe(mesh.surfaces[m.asphalt_patch], offset(cut(centre, s, s + l), left), w,
                 patch_height_m * (1 + 0.1 * i), asphalt_tile_m);
  }
  const int seams = static_cast<int>(total / 22 * wear * draws.uniform(0.3, 2.2));
  for (int i = 0; i < seams; ++i) {
    const double from = draws.uniform(0.5, total * 0.8);
    add_seam(mesh.surfaces[m.tar], centre, from, std::min(total - 0.5, from + draws.uniform(3, 18)),
             draws.uniform(-half + 0.6, half - 0.6), half - 0.5, draws);
  }
  for (double s = draws.uniform(6, 30); s < total - 2; s += draws.uniform(22, 45)) {
    const Station at = station_at(centre, s);
    add_disc(mesh.surfaces[m.manhole], at.point + left_of(at.direction) * draws.uniform(-half + 1, half - 1),
             0.33, seam_height_m + 0.0005);
  }
}

}  // namespace

Mesh carriageway(const StreetNetwork& network, int street, const Materials& materials, std::uint64_t seed) {
  Mesh mesh{"street " + network.streets[street].name, {}};
  const Stream weather = make_stream(seed, "weathering");
  const StreetProfile& profile = network.streets[street].profile;
  Draws draws{substream(make_stream(seed, "road wear"), street)};
  const double wear = draws.uniform(0.2, 2.2);
  for (int s : network.streets[street].segments) {
    const Segment& segment = network.segments[s];
    const Polyline centre = cut(segment.centre, segment.cut_from, length(segment.centre) - segment.cut_to);
    add_lane_asphalt(mesh.surfaces[materials.asphalt], centre, profile, weather);
    Draws own{substream(draws.stream, 1000 + s)};
    add_wear(mesh, centre, profile, materials, wear, own);
  }
  return mesh;
}

Mesh junction_floor(const StreetNetwork& network, int junction, const Materials& materials,
                    std::uint64_t seed) {
  Mesh mesh{"junction " + std::to_string(junction), {}};
  const Polygon border = junction_border(network, junction);
  if (border.empty()) return mesh;
  const Stream weather = make_stream(seed, "weathering");
  const Vec2 middle = network.junctions[junction].position;
  Surface& surface = mesh.surfaces[materials.asphalt];
  constexpr std::uint32_t rings = 4;  // around the middle: something for the weathering to live on
  const auto n = static_cast<std::uint32_t>(border.size());
  for (std::uint32_t ring = 0; ring <= rings; ++ring)
    for (const Vec2& p : border) {
      const Vec2 q = middle + (p - middle) * (static_cast<double>(ring) / rings);
      add_asphalt_vertex(surface, q, weathering(weather, q) - 0.05);
    }
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = ring * n + i, b = ring * n + (i + 1) % n;
      if (ring > 0) surface.indices.insert(surface.indices.end(), {a, b + n, b});
      surface.indices.insert(surface.indices.end(), {a, a + n, b + n});
    }
  return mesh;
}

Mesh pavement(const StreetNetwork& network, const Block& block, const std::vector<double>& pavement_m,
              const Materials& materials, std::uint64_t seed) {
  Mesh mesh;
  const std::size_t n = block.sides.size();
  const Stream weather = make_stream(seed, "weathering");
  const auto ring = [&](double inset) {
    std::vector<double> insets(n);
    for (std::size_t i = 0; i < n; ++i) insets[i] = network.is_road(block.sides[i]) ? inset : 0;
    return outline(network, block, insets, inset);
  };
  const Outline gutter = ring(-0.3), kerb = ring(0), back = ring(kerb_width_m);
  const double widest = *std::max_element(pavement_m.begin(), pavement_m.end());
  const Outline walls = outline(network, block, pavement_m, widest);
  for (std::size_t i = 0; i < kerb.points.size(); ++i) {
    if (!network.is_road(block.sides[kerb.side[i]])) continue;
    const std::size_t k = (i + 1) % kerb.points.size();
    const auto piece = [&](const Outline& o) { return Polyline{o.points[i], o.points[k]}; };
    add_strip(mesh.surfaces[materials.gutter], piece(kerb), piece(gutter),
              {gutter_height_m, gutter_height_m, kerb_tile_m});
    add_strip(mesh.surfaces[materials.kerb], piece(kerb), piece(kerb), {kerb_height_m, -0.05, kerb_tile_m});
    add_strip(mesh.surfaces[materials.kerb], piece(back), piece(kerb),
              {kerb_height_m, kerb_height_m, kerb_tile_m});
    add_strip(mesh.surfaces[materials.paving], piece(walls), piece(back),
              {kerb_height_m, kerb_height_m, paving_tile_m, 3.0, &weather});
  }
  return mesh;
}

}  // namespace cps::city
