#include "scenes/city/streets/surface/road_surface.h"

#include <algorithm>
#include <cmath>

#include "scenes/city/draws.h"
#include "scenes/city/geometry/strip.h"
#include "scenes/city/materials/textures.h"
#include "scenes/city/streets/junctions.h"
#include "scenes/city/streets/surface/heights.h"
#include "scenes/city/streets/surface/road_wear.h"

namespace cps::city {
namespace {

constexpr double apron_m = 0.05;

void add_asphalt_vertex(Surface& surface, const Vec2& p, double light) {
  surface.positions.push_back(lift(p, 0).cast<float>());
  surface.normals.emplace_back(0.f, 1.f, 0.f);
  surface.uvs.emplace_back(Vec2(p.x() / asphalt_tile_m, -p.y() / asphalt_tile_m).cast<float>());
  surface.colors.push_back(gray_color(light));
}

/// The strength of the dark wheel tracks at an offset from the centre line: 0 to 1.
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
  constexpr std::uint32_t rings = 4;  // around the middle: enough vertices for the weathering colours
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
  // The streets' asphalt has more vertices along the common edge, so on a slope there are hairline gaps; an
  // apron closes them.
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec2 &p = border[i], &q = border[(i + 1) % n];
    add_strip(mesh.surfaces[materials.asphalt_patch], {p, q}, {p, q}, {0, -apron_m, asphalt_tile_m});
  }
  return mesh;
}

Mesh pavement(const StreetNetwork& network, const Block& block, const std::vector<double>& pavement_m,
              const Materials& materials) {
  Mesh mesh;
  const std::size_t n = block.sides.size();
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
              {kerb_height_m, kerb_height_m, paving_tile_m});
  }
  return mesh;
}

}  // namespace cps::city
