#include <catch2/catch.hpp>
#include <functional>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/crop/fields_of_view.h"
#include "distortion/label_algebra.h"
#include "numbers/angles.h"

using namespace cps;

namespace {

// All numbers differ, so that exchanging any two is noticed.
const CalibratedCamera odd{"odd",
                           {.width = 640, .height = 362, .fx = 511, .fy = 498, .cx = 331.25, .cy = 170.5},
                           {.k1 = -0.21, .k2 = 0.07, .k3 = -0.011, .p1 = 0.004, .p2 = -0.0023}};

Eigen::Vector2d pixel_of(const CalibratedCamera& calibrated, const Eigen::Vector2d& ideal) {
  return to_pixel(calibrated.pinhole, distort(calibrated.distortion, ideal));
}

/// The ray `seen` of the old camera appears in the new image where the old pixel was moved to.
void check_moves(const CalibratedCamera& after,
                 const std::function<Eigen::Vector2d(Eigen::Vector2d)>& moved_pixel,
                 const std::function<Eigen::Vector2d(Eigen::Vector2d)>& moved_ray) {
  CHECK(after.name == odd.name);
  for (double x : {-0.5, -0.13, 0.0, 0.31, 0.52})
    for (double y : {-0.3, 0.0, 0.07, 0.29}) {
      const Eigen::Vector2d expected = moved_pixel(pixel_of(odd, {x, y}));
      CHECK((pixel_of(after, moved_ray({x, y})) - expected).norm() < 1e-10);
    }
}

Eigen::Vector2d same_ray(Eigen::Vector2d ray) {
  return ray;
}

}  // namespace

TEST_CASE("resizing keeps the frame's edges, each axis by its own factor") {
  // A resize keeps the outer edges, −.5 and W − .5, at the frame's edges. Scaling pixel centres (c' = s c)
  // would be wrong by half a pixel.
  const CalibratedCamera wide = resized(odd, 960, 181);
  const auto moved = [](Eigen::Vector2d p) {
    const double u = (p.x() + 0.5) / 640, v = (p.y() + 0.5) / 362;
    return Eigen::Vector2d(u * 960 - 0.5, v * 181 - 0.5);
  };
  check_moves(wide, moved, same_ray);
  CHECK(hfov_rad(wide.pinhole) == Approx(hfov_rad(odd.pinhole)).epsilon(1e-14));
  const CalibratedCamera back = resized(wide, 640, 362);
  CHECK(back.pinhole.cx == Approx(odd.pinhole.cx).epsilon(1e-14));
  CHECK(back.pinhole.fy == Approx(odd.pinhole.fy).epsilon(1e-14));
  // Twice the size is what splitting every pixel gives.
  CHECK(resized(odd, 1280, 724).pinhole == oversampled(odd.pinhole, 2));
}

TEST_CASE("mirroring exchanges columns, centre of pixel to centre of pixel") {
  check_moves(
      mirrored_left_right(odd), [](auto p) { return Eigen::Vector2d(639 - p.x(), p.y()); },
      [](auto ray) { return Eigen::Vector2d(-ray.x(), ray.y()); });
  CHECK(mirrored_left_right(mirrored_left_right(odd)) == odd);
}

TEST_CASE("fields of view: equal for a centred pinhole, different off-centre and behind a lens") {
  const Pinhole centred = pinhole_from_hfov(640, 360, radians(90));
  const CalibratedCamera plain{"plain", centred, {}};
  const FieldsOfView same = fields_of_view(plain, certify_frame({}, centred).rectangle);
  REQUIRE(same.seen);
  CHECK(degrees(same.label_horizontal_rad) == Approx(90));
  CHECK(degrees(same.ideal_horizontal_rad) == Approx(90));
  CHECK(degrees(same.seen->horizontal_rad) == Approx(90));
  CHECK(degrees(same.label_vertical_rad) == Approx(degrees(2 * std::atan(360.0 / 640))));
  CHECK(same.seen->vertical_rad == Approx(same.ideal_vertical_rad));

  // A sixteenth of the width lies left of the principal point: atan(15/8) + atan(1/8).
  CalibratedCamera shifted = plain;
  shifted.pinhole.cx = 39.5;
  const FieldsOfView off = fields_of_view(shifted, certify_frame({}, shifted.pinhole).rectangle);
  CHECK(degrees(off.label_horizontal_rad) == Approx(90));
  CHECK(off.ideal_horizontal_rad == Approx(std::atan(600.0 / 320) + std::atan(40.0 / 320)));
  REQUIRE(off.seen);
  CHECK(off.seen->horizontal_rad == Approx(off.ideal_horizontal_rad));

  // Barrel: sees more than its label says.
  const FrameCertificate proof = certify_frame(odd.distortion, odd.pinhole);
  REQUIRE(proof.valid());
  const FieldsOfView barrel = fields_of_view(odd, proof.rectangle);
  REQUIRE(barrel.seen);
  CHECK(barrel.seen->horizontal_rad > barrel.label_horizontal_rad);
}
