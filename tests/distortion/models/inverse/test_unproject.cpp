#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <catch2/catch.hpp>
#include <limits>

#include "distortion/models/inverse/unproject.h"
#include "distortion/models/projection.h"
#include "tests/distortion/models/random_models.h"

using namespace cps;

namespace {

constexpr double focal_px = 1000;

/// The unit ray that the sphere of unified_spherical shows at a point of its plane; ξ = 0 is the plane z = 1.
/// Found by intersecting the line from (0, 0, −ξ) with the unit sphere.
Eigen::Vector3d ray_at(double xi, const Eigen::Vector2d& on_plane) {
  // |t (x, y, 1) − (0, 0, ξ)| = 1, the larger t.
  const double a = on_plane.squaredNorm() + 1, discriminant = xi * xi - a * (xi * xi - 1);
  const double t = (xi + std::sqrt(std::max(0.0, discriminant))) / a;
  return Eigen::Vector3d(t * on_plane.x(), t * on_plane.y(), t - xi).normalized();
}

/// The ξ of a lens with a map on a plane.
std::optional<double> sphere(const LensModel& lens) {
  if (const auto* unified = std::get_if<UnifiedSpherical>(&lens)) return unified->xi;
  if (lens.index() < 2) return 0;
  return {};
}

/// A ray of the region, its rim or corners included; empty if none was found in a few draws.
std::optional<Eigen::Vector3d> ray_in(const RayRegion& region, const LensModel& lens, Stream stream,
                                      bool rim) {
  const auto xi = sphere(lens);
  for (int i = 0; i < 10; ++i) {
    const Stream s = substream(stream, i);
    const double share = rim ? 1 : random_uniform(s, 0) * (i % 2 ? random_uniform(s, 1) : 1);
    if (!xi) return random_ray(s, 2, share * region.max_angle_rad);
    const Eigen::Vector2d corner = region.box->max();
    const auto draw = [&](int axis) {
      const double drawn = random_uniform(s, 2 + axis, -1, 1);
      return share * corner[axis] * (rim ? std::copysign(1, drawn) : drawn);
    };
    const Eigen::Vector2d on_plane(draw(0), draw(1));
    const Eigen::Vector3d ray = ray_at(*xi, on_plane);
    // Beyond the sphere's reach the line misses it; ray_at() then touches it somewhere else.
    const bool is_met = (project(UnifiedSpherical{.xi = *xi}, ray).point - on_plane).norm() < 1e-9;
    if (is_met && contains(region, lens, ray)) return ray;
  }
  return {};
}

struct RoundTrip {
  long lenses = 0, points = 0, failed = 0;
  double worst_px = 0;  ///< |project(unproject(point)) − point|
};

/// A random lens of a family on the region on which it is proved, with some rays of it. Points farther out
/// than a hundred focal lengths are left out: no picture reaches them.
void make_round_trips(std::size_t family, std::uint64_t index, int points, RoundTrip& result) {
  const Stream stream = make_stream(family, "unproject");
  const LensModel lens = random_model(family, stream, index);
  const ModelCertificate proof = certify_region(lens);
  if (!proof.valid) return;
  ++result.lenses;
  for (int k = 0; k < points; ++k) {
    const auto ray = ray_in(proof.region, lens, substream(substream(stream, ~index), k), k == 0);
    if (!ray) continue;
    const Eigen::Vector2d point = project(lens, *ray).point;
    if (point.norm() > 100) continue;
    ++result.points;
    if (const auto found = unproject(lens, proof.region, point))
      result.worst_px = std::max(result.worst_px, focal_px * (project(lens, *found).point - point).norm());
    else
      ++result.failed;
  }
}

RoundTrip round_trips(std::size_t family, std::size_t lenses, int points) {
  return tbb::parallel_reduce(
      tbb::blocked_range<std::size_t>(0, lenses), RoundTrip{},
      [&](const tbb::blocked_range<std::size_t>& range, RoundTrip result) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) make_round_trips(family, i, points, result);
        return result;
      },
      [](const RoundTrip& a, const RoundTrip& b) {
        return RoundTrip{a.lenses + b.lenses, a.points + b.points, a.failed + b.failed,
                         std::max(a.worst_px, b.worst_px)};
      });
}

}  // namespace

TEST_CASE("every ray of a proved region comes back, all families") {
  for (std::size_t family = 0; family < std::variant_size_v<LensModel>; ++family) {
    const RoundTrip result = round_trips(family, 10'000, 3);
    INFO(family_names()[family] << ": worst " << result.worst_px << " px, " << result.lenses << " lenses, "
                                << result.points << " points");
    CHECK(result.failed == 0);
    CHECK(result.worst_px < 1e-6);
    CHECK(result.lenses > 9'000);
    CHECK(result.points > result.lenses);
  }
}

TEST_CASE("a fisheye on which Newton's method goes back and forth is inverted, too") {
  // Found among a million lenses: the method never left the bracket and never arrived.
  const KannalaBrandt lenses[] = {
      {0.11881026736924374, 0.045176903434039808, 0.01157585553096604, -0.0084411131146018732},
      {0.085544951743924791, 0.025773085397176952, 0.002356893348613086, -0.011025214975993699}};
  const Eigen::Vector2d points[] = {{0.040178453666241051, 1.7125137599452112},
                                    {1.462190535443858, 0.21912515878577427}};
  for (int i : {0, 1}) {
    const ModelCertificate proof = certify_region(lenses[i]);
    REQUIRE(proof.valid);
    const auto ray = unproject(lenses[i], proof.region, points[i]);
    REQUIRE(ray);
    CHECK((project(lenses[i], *ray).point - points[i]).norm() < 1e-12);
  }
}

TEST_CASE("a million lenses of every family", "[slow]") {
  for (std::size_t family = 0; family < std::variant_size_v<LensModel>; ++family) {
    const RoundTrip result = round_trips(family, 1'000'000, 8);
    WARN(family_names()[family] << ": worst round trip " << result.worst_px << " px, " << result.lenses
                                << " lenses, " << result.points << " points");
    CHECK(result.failed == 0);
    CHECK(result.worst_px < 1e-6);
  }
}

TEST_CASE("the ray that comes back is the one that was sent, where the lens is steep enough to tell") {
  for (std::size_t family = 0; family < std::variant_size_v<LensModel>; ++family) {
    const Stream stream = make_stream(family, "same ray");
    int tried = 0;
    for (int i = 0; i < 2000; ++i) {
      const LensModel lens = random_model(family, stream, i);
      const ModelCertificate proof = certify_region(lens);
      const auto ray = proof.valid ? ray_in(proof.region, lens, substream(stream, ~i), false) : std::nullopt;
      if (!ray) continue;
      const ProjectedRay at = project(lens, *ray);
      const double stretch = ray_jacobian(at.jacobian).norm();  // radians per unit of the image
      if (at.point.norm() > 10 || !(stretch < 100)) continue;
      const auto found = unproject(lens, proof.region, at.point);
      INFO(description(lens) << ", ray " << ray->transpose());
      REQUIRE(found);
      REQUIRE(std::abs(found->norm() - 1) < 1e-13);
      REQUIRE((*found - *ray).norm() < 1e-13 * (1 + stretch) * (1 + at.jacobian.norm()));
      ++tried;
    }
    INFO(family_names()[family]);
    CHECK(tried > 500);
  }
}

TEST_CASE("points that only rays outside a region show are outside its image") {
  for (std::size_t family = 0; family < std::variant_size_v<LensModel>; ++family) {
    const Stream stream = make_stream(family, "outside a region");
    int inside = 0, outside = 0;
    for (int i = 0; i < 3000; ++i) {
      const LensModel lens = random_model(family, stream, i);
      const ModelCertificate proof = certify_region(lens);
      if (!proof.valid) continue;
      // The lens is one-to-one on the whole region, so nothing of a part shows where the rest does.
      RayRegion part = proof.region;
      part.max_angle_rad *= i % 2 ? 0.7 : 1;
      if (part.box && i % 2 == 0)
        *part.box = Eigen::AlignedBox2d(0.6 * part.box->min(), 0.7 * part.box->max());
      const auto ray = ray_in(proof.region, lens, substream(stream, ~i), false);
      if (!ray) continue;
      const Eigen::Vector2d point = project(lens, *ray).point;
      const bool is_inside = contains(part, lens, *ray);
      // Too near to an edge to tell apart in double precision.
      const Eigen::Vector3d towards_axis = (*ray + Eigen::Vector3d(0, 0, 1e-4)).normalized();
      const Eigen::Vector3d outwards = (*ray - Eigen::Vector3d(0, 0, 1e-4)).normalized();
      if (contains(part, lens, towards_axis) != contains(part, lens, outwards) || point.norm() > 1e3)
        continue;
      INFO(description(lens) << ", ray " << ray->transpose());
      REQUIRE(unproject(lens, part, point).has_value() == is_inside);
      ++(is_inside ? inside : outside);
    }
    INFO(family_names()[family]);
    CHECK(inside > 300);
    CHECK(outside > 100);
  }
}

TEST_CASE("points far outside or not finite have no ray") {
  const double infinity = std::numeric_limits<double>::infinity();
  for (std::size_t family = 0; family < std::variant_size_v<LensModel>; ++family) {
    const LensModel lens = random_model(family, make_stream(9, "no ray"), 3);
    RayRegion region{.max_angle_rad = 0.5};
    if (sphere(lens)) region.box = Eigen::AlignedBox2d(Eigen::Vector2d(-.2, -.2), Eigen::Vector2d(.2, .2));
    INFO(description(lens));
    CHECK(unproject(lens, region, {0, 0}));
    CHECK_FALSE(unproject(lens, region, {1e6, 3}));
    CHECK_FALSE(unproject(lens, region, {std::nan(""), 0}));
    CHECK_FALSE(unproject(lens, region, {0, infinity}));
  }
}

TEST_CASE("a ray's derivative inverts the projection's and keeps its length") {
  for (std::size_t family = 0; family < std::variant_size_v<LensModel>; ++family) {
    const Stream stream = make_stream(family, "unproject jacobian");
    for (int i = 0; i < 300; ++i) {
      const LensModel lens = random_model(family, stream, i);
      const ModelCertificate proof = certify_region(lens);
      if (!proof.valid) continue;
      const Eigen::Vector2d point = project(lens, random_ray(stream, i, 0.3)).point;
      const auto at = unproject_with_jacobian(lens, proof.region, point);
      if (!at) continue;
      const Eigen::Matrix<double, 2, 3> forward = project(lens, at->ray).jacobian;
      const double size = 1 + forward.norm() * at->jacobian.norm();
      INFO(description(lens));
      REQUIRE((forward * at->jacobian - Eigen::Matrix2d::Identity()).norm() < 1e-12 * size * size);
      REQUIRE((at->jacobian.transpose() * at->ray).norm() < 1e-12 * size);
      if (at->jacobian.norm() > 10) continue;  // too flat for differences
      constexpr double h = 1e-6;
      for (int axis = 0; axis < 2; ++axis) {
        const Eigen::Vector2d step = h * Eigen::Vector2d::Unit(axis);
        const auto plus = unproject(lens, proof.region, point + step);
        const auto minus = unproject(lens, proof.region, point - step);
        if (!plus || !minus) continue;
        REQUIRE(((*plus - *minus) / (2 * h) - at->jacobian.col(axis)).norm() < 1e-6 * size * size);
      }
    }
  }
}
