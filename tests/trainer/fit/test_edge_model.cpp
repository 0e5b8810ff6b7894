#include <catch2/catch.hpp>
#include <cmath>

#include "numbers/angles.h"
#include "trainer/fit/edge_model.h"

using namespace cps;

namespace {

constexpr ImageSize kitti{1392, 512};

/// A camera like KITTI's with everything out of line.
FitVector crooked() {
  FitVector p;
  p << radians(84), -.22, .07, -.012, .004, -.006, .508, .47, radians(4), radians(-3), radians(11);
  return p;
}

CalibratedCamera camera_of(const FitVector& p) {
  Outputs outputs;
  for (int i = 0; i < output_count; ++i) outputs[i] = p[i];
  return *to_camera(outputs, TargetSpace::seen, kitti.width, kitti.height);
}

/// Up and across in the camera's frame by rotations, the independent way: the street's axes are turned by yaw
/// about the vertical, then the camera by pitch about its x axis and by roll about its z axis.
Eigen::Vector3d street_axis(const FitVector& p, const Eigen::Vector3d& axis) {
  using Eigen::AngleAxisd;
  using Eigen::Vector3d;
  return AngleAxisd(-p[roll_parameter], Vector3d::UnitZ()) *
         AngleAxisd(-p[pitch_parameter], Vector3d::UnitX()) *
         AngleAxisd(-p[yaw_parameter], Vector3d::UnitY()) * axis;
}

/// The direction, in pixels, of a short piece of a line in space along `axis`, seen at `pixel`.
Eigen::Vector2d image_of_line(const FitVector& p, const Eigen::Vector3d& axis, const Eigen::Vector2d& ideal) {
  const CalibratedCamera camera = camera_of(p);
  const auto pixel_of = [&](const Eigen::Vector3d& point) {
    return to_pixel(camera.pinhole, distort(camera.distortion, point.hnormalized()));
  };
  const Eigen::Vector3d middle = 7 * ideal.homogeneous(), along = 1e-4 * street_axis(p, axis);
  return pixel_of(middle + along) - pixel_of(middle - along);
}

/// A pixel in half diagonals from the picture's middle.
Eigen::Vector2d in_half_diagonals(const Eigen::Vector2d& pixel) {
  return (pixel - Eigen::Vector2d(kitti.width - 1, kitti.height - 1) / 2) /
         (std::hypot(kitti.width, kitti.height) / 2);
}

}  // namespace

TEST_CASE("the tilts of edges are those of projected lines in space") {
  const FitVector p = crooked();
  const StreetCamera street = street_camera(p, kitti);
  const CalibratedCamera camera = camera_of(p);
  int seen = 0;
  for (double x : {-.7, -.3, .1, .6})
    for (double y : {-.2, 0., .25}) {
      const Eigen::Vector2d ideal(x, y),
          at = in_half_diagonals(to_pixel(camera.pinhole, distort(camera.distortion, ideal)));
      const auto tilts = edge_tilts(street, at.x(), at.y());
      const Eigen::Vector2d up = image_of_line(p, -Eigen::Vector3d::UnitY(), ideal),
                            across = image_of_line(p, Eigen::Vector3d::UnitX(), ideal);
      for (int family : {0, 1}) {
        const double tilt = family == 0 ? -up.x() / up.y() : -across.y() / across.x();
        if (std::abs(tilt) > .39) continue;
        REQUIRE(tilts[family]);
        CHECK(tilts[family]->tilt == Approx(tilt).margin(1e-6));
        ++seen;
      }
    }
  CHECK(seen > 15);
}

TEST_CASE("slopes of the tilts are their differences for every parameter") {
  const FitVector p = crooked();
  for (double x : {-.8, -.2, .7})
    for (double y : {-.25, .1, .3}) {
      const auto tilts = edge_tilts(street_camera(p, kitti), x, y);
      for (int i = 0; i < fit_parameter_count; ++i) {
        constexpr double step = 1e-5;
        FitVector low = p, high = p;
        low[i] -= step;
        high[i] += step;
        const auto below = edge_tilts(street_camera(low, kitti), x, y),
                   above = edge_tilts(street_camera(high, kitti), x, y);
        for (int family : {0, 1}) {
          if (!tilts[family]) continue;
          REQUIRE(below[family]);
          REQUIRE(above[family]);
          const double difference = (above[family]->tilt - below[family]->tilt) / (2 * step);
          CHECK(tilts[family]->slope[i] == Approx(difference).epsilon(1e-4).margin(1e-6));
        }
      }
    }
}

TEST_CASE("a level camera without distortion sees upright edges upright") {
  FitVector p = FitVector::Zero();
  p[0] = radians(70);
  p[6] = .5 * (kitti.width - 1) / kitti.width;
  p[7] = .5 * (kitti.height - 1) / kitti.height;
  const StreetCamera level = street_camera(p, kitti);
  for (double x : {-.9, 0., .5})
    for (const auto& tilt : edge_tilts(level, x, .2)) {
      REQUIRE(tilt);
      CHECK(tilt->tilt == Approx(0).margin(1e-12));
      // To first order, −2 x y of the radial coefficient: trainer/images/orientation/tilt_fit.h.
      CHECK(tilt->slope[1] == Approx(-2 * x * .2).margin(1e-9));
    }
}

TEST_CASE("there are no tilts where the lens is folded or edges are too steep") {
  FitVector p = crooked();
  p[1] = -1.5;
  p[2] = p[3] = 0;
  const auto folded = edge_tilts(street_camera(p, kitti), .8, .2);
  CHECK_FALSE(folded[0]);
  CHECK_FALSE(folded[1]);

  FitVector rolled = crooked();
  rolled[roll_parameter] = radians(30);  // tan 30° = .58
  CHECK_FALSE(edge_tilts(street_camera(rolled, kitti), 0, 0)[0]);
}
