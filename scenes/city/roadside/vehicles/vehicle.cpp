#include "scenes/city/roadside/vehicles/vehicle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scenes/city/roadside/vehicles/vehicle_parts.h"

namespace cps::city {
namespace {

constexpr double sill_m = 0.2;

/// The points of a body's cross-section, from the sill up to the middle of the roof, for one side.
constexpr int contour_points = 9;
enum Contour { sill, flank_low, flank, shoulder, glass_foot, glass_top, roof_edge, screen_edge, middle };

double smooth(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x * x * (3 - 2 * x);
}

/// Height of the body's outline at x: nose, bonnet, windscreen, roof, rear window, boot.
double top_line(const VehicleClass& c, double x) {
  const double front = c.length_m / 2, rear = -c.length_m / 2;
  if (x > c.windscreen_foot_m) {
    const double t = (front - x) / (front - c.windscreen_foot_m);
    return c.bonnet_height_m - 0.22 * std::pow(1 - t, 2.2);
  }
  if (x > c.windscreen_top_m) {
    const double t = (c.windscreen_foot_m - x) / (c.windscreen_foot_m - c.windscreen_top_m);
    return std::lerp(c.bonnet_height_m, c.height_m - 0.04,
                     t - 0.06 * std::sin(2 * std::numbers::pi * t) * 0.3);
  }
  if (x > c.rear_top_m) {
    const double t = (c.windscreen_top_m - x) / (c.windscreen_top_m - c.rear_top_m);
    return c.height_m - 0.04 + 0.04 * std::sin(std::numbers::pi * std::clamp(t, 0.0, 1.0)) - 0.05 * t * t;
  }
  if (x > c.rear_foot_m)
    return std::lerp(c.height_m - 0.09, c.boot_height_m, (c.rear_top_m - x) / (c.rear_top_m - c.rear_foot_m));
  return c.boot_height_m - 0.10 * smooth((c.rear_foot_m - x) / std::max(0.1, c.rear_foot_m - rear));
}

/// Height of the flank's lower edge at x: the sill, with circular wheel arches, rising towards the bumpers.
double bottom_line(const VehicleClass& c, double x) {
  double z = sill_m + 0.06 * std::pow(std::abs(x) / (c.length_m / 2), 4.0);
  const double arch = c.wheel_radius_m + 0.055;
  for (const double axle : {c.front_axle_m, c.rear_axle_m})
    if (std::abs(x - axle) < arch)
      z = std::max(z, c.wheel_radius_m + std::sqrt(arch * arch - (x - axle) * (x - axle)));
  return z;
}

std::array<Vec3, contour_points> section(const VehicleClass& c, double x) {
  const double ends = std::abs(x) / (c.length_m / 2);
  const double w = c.width_m / 2 * (1 - 0.16 * std::pow(ends, 7));
  const double top = top_line(c, x), low = bottom_line(c, x);
  const double belt = std::min(c.belt_height_m, top - 0.05);
  const double cabin = std::clamp((top - belt) / (c.height_m - c.belt_height_m), 0.0, 1.0);
  const double roof_w = w * std::lerp(0.90, c.panel_van ? 0.86 : 0.74, cabin);
  const double edge = top - 0.035 - 0.03 * cabin;
  const double waist = std::max(low + 0.02, 0.58 * belt + 0.1);
  const Vec2 foot(w * 0.965, belt), head(roof_w, edge);
  const Vec2 glass_low = foot + (head - foot) * 0.06, glass_high = foot + (head - foot) * 0.9;
  return {Vec3(x, low, w * 0.97),
          Vec3(x, std::lerp(low, waist, 0.4), w * 0.995),
          Vec3(x, waist, w),
          Vec3(x, foot.y(), foot.x()),
          Vec3(x, glass_low.y(), glass_low.x()),
          Vec3(x, glass_high.y(), glass_high.x()),
          Vec3(x, head.y(), head.x()),
          Vec3(x, top - 0.012, roof_w * 0.88),
          Vec3(x, top, 0)};
}

/// The x of the body's cross-sections, close together where the outline bends.
std::vector<double> stations(const VehicleClass& c) {
  std::vector<double> xs;
  const double half = c.length_m / 2;
  for (int i = 0; i <= 26; ++i) xs.push_back(-half + c.length_m * i / 26);
  for (const double end : {0.03, 0.08}) xs.insert(xs.end(), {half - end, -half + end});
  for (const double corner : {c.windscreen_foot_m, c.windscreen_top_m, c.rear_top_m, c.rear_foot_m})
    xs.push_back(corner);
  const double arch = c.wheel_radius_m + 0.055;
  for (const double axle : {c.front_axle_m, c.rear_axle_m})
    for (int i = 0; i <= 12; ++i) xs.push_back(axle + arch * std::cos(std::numbers::pi * i / 12));
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end(), [](double a, double b) { return b - a < 0.012; }), xs.end());
  return xs;
}

MaterialId cell_material(const VehicleClass& c, const Materials& m, MaterialId paint, double x, int band) {
  if (band == glass_foot) {
    const double front = c.windscreen_foot_m - 0.22,
                 rear = c.panel_van ? c.windscreen_top_m - 0.9 : c.rear_foot_m + 0.25;
    const double pillar = c.windscreen_top_m - 0.95;
    const bool is_glass = x < front && x > rear && (c.panel_van || std::abs(x - pillar) > 0.055);
    return is_glass ? m.car_glass : paint;
  }
  if (band == screen_edge) {
    if (x < c.windscreen_foot_m - 0.03 && x > c.windscreen_top_m + 0.02) return m.car_glass;
    if (!c.panel_van && x < c.rear_top_m - 0.04 && x > c.rear_foot_m + 0.04) return m.car_glass;
  }
  if (band == sill) return m.car_trim;
  if (band == flank && x > c.length_m / 2 - 0.28) return m.head_light;
  if (band == flank && x < -c.length_m / 2 + 0.16) return m.tail_light;
  return paint;
}

void add_body(Mesh& mesh, const VehicleClass& c, const Materials& m, MaterialId paint) {
  const std::vector<double> xs = stations(c);
  std::vector<std::array<Vec3, contour_points>> grid;
  for (double x : xs) grid.push_back(section(c, x));
  const int n = static_cast<int>(grid.size());
  const auto normal_at = [&](int i, int j) -> Vec3 {
    const Vec3 along = grid[std::min(i + 1, n - 1)][j] - grid[std::max(i - 1, 0)][j];
    const Vec3 around = grid[i][std::min(j + 1, contour_points - 1)] - grid[i][std::max(j - 1, 0)];
    if (j == middle) return Vec3(-along.y(), along.x(), 0).normalized();
    return along.cross(around).normalized();
  };
  for (int i = 0; i + 1 < n; ++i)
    for (int j = 0; j + 1 < contour_points; ++j) {
      Surface& surface = mesh.surfaces[cell_material(c, m, paint, (xs[i] + xs[i + 1]) / 2, j)];
      for (const double side : {1.0, -1.0}) {
        const auto first = static_cast<std::uint32_t>(surface.positions.size());
        for (const auto& [a, b] : {std::pair{i, j}, {i + 1, j}, {i + 1, j + 1}, {i, j + 1}}) {
          const Vec3 mirror(1, 1, side);
          surface.positions.push_back(grid[a][b].cwiseProduct(mirror).cast<float>());
          surface.normals.push_back(normal_at(a, b).cwiseProduct(mirror).cast<float>());
          surface.uvs.emplace_back(0.f, 0.f);
        }
        if (side > 0)
          surface.indices.insert(surface.indices.end(),
                                 {first, first + 1, first + 2, first, first + 2, first + 3});
        else
          surface.indices.insert(surface.indices.end(),
                                 {first, first + 2, first + 1, first, first + 3, first + 2});
      }
    }
  for (const bool front : {true, false}) {  // flat faces at both ends, behind bumpers and lights
    const auto& end = front ? grid.back() : grid.front();
    std::vector<Vertex> face;
    for (int j = 0; j < contour_points; ++j) face.push_back({end[j]});
    for (int j = contour_points - 2; j >= 0; --j) face.push_back({end[j].cwiseProduct(Vec3(1, 1, -1))});
    if (front) std::reverse(face.begin(), face.end());
    add_polygon(mesh.surfaces[paint], face);
  }
}

void add_fittings(Mesh& mesh, const VehicleClass& c, const Materials& m, MaterialId paint) {
  const double half = c.length_m / 2, w = c.width_m / 2;
  add_block(mesh.surfaces[m.car_trim], {-half + 0.12, 0.19, -w + 0.25},
            {half - 0.12, 0.62, w - 0.25});  // backs the wheel wells
  add_block(mesh.surfaces[m.car_trim], {half - 0.05, 0.27, -0.62 * w},
            {half + 0.015, 0.40, 0.62 * w});  // air intake
  add_block(mesh.surfaces[m.car_trim], {half - 0.05, 0.52, -0.34 * w},
            {half + 0.012, 0.62, 0.34 * w});  // grille
  add_block(mesh.surfaces[m.car_trim], {-half - 0.015, 0.28, -0.78 * w}, {-half + 0.05, 0.42, 0.78 * w});
  add_block(mesh.surfaces[m.number_plate], {half, 0.42, -0.26}, {half + 0.022, 0.53, 0.26});
  add_block(mesh.surfaces[m.number_plate], {-half - 0.012, 0.62, -0.26}, {-half, 0.73, 0.26});
  add_blocks(mesh.surfaces[m.head_light], {half - 0.05, 0.57, 0.48 * w}, {half + 0.01, 0.67, 0.80 * w});
  add_blocks(mesh.surfaces[m.tail_light], {-half - 0.01, 0.66, 0.58 * w}, {-half + 0.05, 0.84, 0.80 * w});
  add_blocks(mesh.surfaces[paint], {c.windscreen_foot_m - 0.30, c.belt_height_m, w * 0.96},
             {c.windscreen_foot_m - 0.16, c.belt_height_m + 0.12, w + mirror_m});
  for (const double door : {c.windscreen_top_m - 0.72, c.windscreen_top_m - 1.62})
    if (!c.panel_van)
      add_blocks(mesh.surfaces[m.car_trim], {door - 0.1, c.belt_height_m - 0.16, w * 0.95},
                 {door + 0.06, c.belt_height_m - 0.13, w * 0.985 + 0.02});
}

void add_wheel(Mesh& mesh, const VehicleClass& c, const Materials& m, double x, double side) {
  constexpr int sectors = 20;
  const double r = c.wheel_radius_m, outer = c.width_m / 2 - 0.02, inner = outer - 0.2;
  const Vec3 hub(x, r, 0), out(0, 0, side);
  add_tube(mesh.surfaces[m.tyre], hub + out * inner, hub + out * outer, r, r, sectors);
  const auto at = [&](int i, double radius, double w) -> Vec3 {
    const double a = 2 * std::numbers::pi * i / sectors;
    return hub + out * w + Vec3(std::cos(a), std::sin(a), 0) * radius;
  };
  const auto ring = [&](Surface& s, int i, double r0, double w0, double r1, double w1) {
    const Vec3 a = at(i, r0, w0), b = at(i + 1, r0, w0), p = at(i, r1, w1), q = at(i + 1, r1, w1);
    if (side > 0)
      add_quad(s, {p}, {q}, {b}, {a});
    else
      add_quad(s, {a}, {b}, {q}, {p});
  };
  for (int i = 0; i < sectors; ++i) {
    ring(mesh.surfaces[m.tyre], i, 0.66 * r, outer, r, outer);
    ring(mesh.surfaces[m.rim], i, 0.58 * r, outer - 0.03, 0.66 * r, outer);
    const bool spoke = i % 4 < 2;  // five spokes
    ring(mesh.surfaces[spoke ? m.rim : m.car_trim], i, 0.16 * r, outer - (spoke ? 0.01 : 0.06), 0.58 * r,
         outer - (spoke ? 0.03 : 0.06));
    ring(mesh.surfaces[m.rim], i, 0.0, outer - 0.005, 0.16 * r, outer - 0.01);
  }
}

}  // namespace

const std::vector<VehicleClass>& vehicle_classes() {
  static const std::vector<VehicleClass> classes{
      {"hatchback", 0.27, 4.05, 1.76, 1.47, 0.31, 1.27, -1.25, 0.95, 0.93, 0.95, 1.02, 0.28, -1.45, -1.93},
      {"saloon", 0.15, 4.60, 1.82, 1.44, 0.32, 1.42, -1.38, 0.92, 0.92, 1.02, 0.95, 0.18, -0.95, -1.68},
      {"estate", 0.19, 4.68, 1.82, 1.47, 0.32, 1.45, -1.36, 0.93, 0.93, 0.98, 0.98, 0.22, -1.78, -2.20},
      {"off-roader", 0.14, 4.45, 1.87, 1.69, 0.36, 1.36, -1.30, 1.06, 1.06, 1.08, 0.95, 0.32, -1.60, -2.05},
      {"city car", 0.12, 3.60, 1.64, 1.49, 0.28, 1.18, -1.15, 0.95, 0.95, 0.98, 1.02, 0.42, -1.30, -1.70},
      {"people carrier", 0.06, 4.90, 1.90, 1.94, 0.33, 1.52, -1.48, 1.10, 1.08, 1.12, 1.80, 1.05, -2.24,
       -2.40},
      {"van", 0.07, 5.30, 1.98, 2.35, 0.34, 1.75, -1.55, 1.20, 1.22, 1.20, 2.05, 1.40, -2.50, -2.60, true},
  };
  return classes;
}

Mesh vehicle(const VehicleClass& c, const Materials& materials, MaterialId paint) {
  Mesh mesh{c.name, {}};
  add_body(mesh, c, materials, paint);
  add_fittings(mesh, c, materials, paint);
  for (const double axle : {c.front_axle_m, c.rear_axle_m})
    for (const double side : {1.0, -1.0}) add_wheel(mesh, c, materials, axle, side);
  return mesh;
}

}  // namespace cps::city
