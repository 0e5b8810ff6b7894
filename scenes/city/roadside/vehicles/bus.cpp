#include "scenes/city/roadside/vehicles/bus.h"

#include <algorithm>
#include <cmath>

#include "scenes/city/roadside/vehicles/vehicle_parts.h"

namespace cps::city {
namespace {

constexpr double half_length_m = bus_length_m / 2, half_width_m = bus_width_m / 2;
constexpr double front_axle_m = 3.3, rear_axle_m = -2.6, wheel_radius_m = 0.48, arch_m = 0.56;
/// Heights of the body's bands: skirt, belt line, upper edge of the windows, edge and middle of the roof.
constexpr double skirt_m = 0.3, belt_m = 1.08, lintel_m = 2.48, eaves_m = 2.86, roof_m = 3.0;
constexpr double door_half_m = 0.62;
constexpr double doors_m[] = {5.0, 0.4, -4.4};

/// Half the body's width at `x`; its corners are quarter circles.
double half_width_at(double x) {
  const double radius = x > 0 ? 0.4 : 0.2, into = std::max(0.0, std::abs(x) - (half_length_m - radius));
  return half_width_m - radius + std::sqrt(std::max(0.0, radius * radius - into * into));
}

double bottom_at(double x) {
  double z = skirt_m;
  for (const double axle : {front_axle_m, rear_axle_m})
    if (std::abs(x - axle) < arch_m)
      z = std::max(z, wheel_radius_m + std::sqrt(arch_m * arch_m - (x - axle) * (x - axle)));
  return z;
}

bool is_door(double x) {
  return std::any_of(std::begin(doors_m), std::end(doors_m),
                     [&](double door) { return std::abs(x - door) < door_half_m; });
}

/// The x of the body's cross-sections: where it bends, and at both edges of window posts and doors.
std::vector<double> stations() {
  std::vector<double> xs;
  for (int i = 0; i <= 5; ++i) {
    const double a = i * 0.31415926;
    xs.insert(xs.end(), {half_length_m - 0.4 * (1 - std::cos(a)), -half_length_m + 0.2 * (1 - std::cos(a))});
  }
  for (const double axle : {front_axle_m, rear_axle_m})
    for (int i = 0; i <= 10; ++i) xs.push_back(axle + arch_m * std::cos(0.31415926 * i));
  for (double post = -5.6; post < 5.7; post += 1.4) xs.insert(xs.end(), {post - 0.05, post + 0.05});
  for (const double door : doors_m)
    for (const double edge : {-door_half_m, -0.03, 0.03, door_half_m}) xs.push_back(door + edge);
  std::sort(xs.begin(), xs.end());
  xs.erase(std::unique(xs.begin(), xs.end(), [](double a, double b) { return b - a < 0.008; }), xs.end());
  return xs;
}

bool is_post(double x) {
  const double from_post = std::abs(std::remainder(x + 5.6, 1.4));
  return from_post < 0.05 || x < -5.65;
}

void add_sides(Mesh& mesh, const Materials& m, MaterialId paint) {
  const std::vector<double> xs = stations();
  for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
    const double a = xs[i], b = xs[i + 1], x = (a + b) / 2;
    for (const double side : {1.0, -1.0}) {
      const bool door = side > 0 && is_door(x);
      const bool leaf_gap = door && std::any_of(std::begin(doors_m), std::end(doors_m),
                                                [&](double d) { return std::abs(x - d) < 0.03; });
      const MaterialId windows = leaf_gap     ? m.car_trim
                                 : door       ? m.car_glass
                                 : is_post(x) ? paint
                                              : m.car_glass;
      const auto band = [&](MaterialId material, double za0, double zb0, double za1, double zb1,
                            double inset) {
        const double wa = half_width_at(a), wb = half_width_at(b);
        const Vertex p{{a, za0, side * wa}}, q{{b, zb0, side * wb}}, r{{b, zb1, side * (wb - inset)}},
            s{{a, za1, side * (wa - inset)}};
        side > 0 ? add_quad(mesh.surfaces[material], p, q, r, s)
                 : add_quad(mesh.surfaces[material], q, p, s, r);
      };
      band(door ? (leaf_gap ? m.car_trim : m.car_glass) : paint, bottom_at(a), bottom_at(b), belt_m, belt_m,
           0);
      band(windows, belt_m, belt_m, lintel_m, lintel_m, 0);
      band(paint, lintel_m, lintel_m, eaves_m, eaves_m, 0);
      band(paint, eaves_m, eaves_m, roof_m, roof_m, 0.3);
    }
    const double wa = half_width_at(a) - 0.3, wb = half_width_at(b) - 0.3;
    add_quad(mesh.surfaces[m.sign_white], {{a, roof_m, wa}}, {{b, roof_m, wb}}, {{b, roof_m, -wb}},
             {{a, roof_m, -wa}});
  }
}

/// Adds the flat front and rear, and the roof's slopes above them.
void add_ends(Mesh& mesh, const Materials& m, MaterialId paint) {
  for (const bool front : {true, false}) {
    const double x = front ? half_length_m : -half_length_m, w = half_width_at(x);
    const auto band = [&](MaterialId material, double low, double high, double inset = 0) {
      const Vertex p{{x, low, w}}, q{{x, low, -w}}, r{{x, high, -(w - inset)}}, s{{x, high, w - inset}};
      front ? add_quad(mesh.surfaces[material], p, q, r, s) : add_quad(mesh.surfaces[material], q, p, s, r);
    };
    band(paint, skirt_m, front ? 0.95 : 1.25);
    band(m.car_glass, front ? 0.95 : 1.25, front ? lintel_m : 2.3);
    band(front ? m.signal_off : paint, front ? lintel_m : 2.3, eaves_m);
    band(paint, eaves_m, roof_m, 0.3);
  }
}

void add_fittings(Mesh& mesh, const Materials& m) {
  constexpr double front = half_length_m, w = half_width_m;
  // Fills the space below the floor and in the wheel arches.
  add_block(mesh.surfaces[m.car_trim], {-front + 0.3, 0.24, -w + 0.42}, {front - 0.45, belt_m, w - 0.42});
  add_block(mesh.surfaces[m.car_trim], {front - 0.02, skirt_m, -0.8}, {front + 0.02, 0.42, 0.8});
  add_block(mesh.surfaces[m.number_plate], {front, 0.46, -0.26}, {front + 0.015, 0.57, 0.26});
  add_block(mesh.surfaces[m.number_plate], {-front - 0.015, 0.6, -0.26}, {-front, 0.71, 0.26});
  add_block(mesh.surfaces[m.bus_display], {front, lintel_m + 0.08, -0.62}, {front + 0.012, 2.78, 0.62});
  add_block(mesh.surfaces[m.sign_white], {-2.2, roof_m - 0.01, -0.8}, {0.8, bus_height_m, 0.8});
  add_blocks(mesh.surfaces[m.head_light], {front - 0.03, 0.56, 0.45}, {front + 0.012, 0.74, 0.84});
  add_blocks(mesh.surfaces[m.tail_light], {-front - 0.012, 0.75, 0.78}, {-front + 0.03, 1.15, 0.98});
  add_blocks(mesh.surfaces[m.tail_light], {-front - 0.012, 2.5, 0.78}, {-front + 0.03, 2.62, 0.98});
  add_blocks(mesh.surfaces[m.car_trim], {front - 0.22, 1.7, w - 0.02}, {front - 0.1, 2.12, w + bus_mirror_m});
  for (const double axle : {front_axle_m, rear_axle_m})
    for (const double side : {1.0, -1.0})
      add_truck_wheel(mesh, m, {axle, wheel_radius_m, side * (w - 0.03)}, wheel_radius_m, 0.3, side);
}

}  // namespace

Mesh bus(const Materials& m, MaterialId paint) {
  Mesh mesh{"bus", {}};
  add_sides(mesh, m, paint);
  add_ends(mesh, m, paint);
  add_fittings(mesh, m);
  return mesh;
}

}  // namespace cps::city
