#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "distortion/crop/limits.h"
#include "sampler/lenses/shape_prior.h"
#include "sampler/lenses/tangential_draw.h"

using namespace cps;

namespace {

/// The four cameras' final focal length, principal point and lens: calib_cam_to_cam.txt of 2011-09-26 (Geiger
/// et al. 2013). Our renders have square pixels, so fx stands for both.
struct KittiCamera {
  double fx, cx, cy;
  Distortion lens;
};
const KittiCamera kitti[] = {
    {984.2439, 690.0, 233.1966, {-.3728755, .2037299, -.07233722, .002219027, .001383707}},
    {989.5267, 702.0, 245.559, {-.3644661, .1790019, -.0531406, .001148107, -.0006298563}},
    {959.791, 696.0217, 224.1806, {-.3691481, .1968681, -.06770705, .001353473, .0005677587}},
    {903.7596, 695.7519, 224.2509, {-.3639558, .1788651, -.0538246, .0006029694, -.0003922424}}};

const Eigen::Vector2d centre(695.5, 255.5);

/// The base whose border-free crop has the camera's lens and focal length and this principal point, by
/// bisection on its own focal length.
Pinhole base_of(const KittiCamera& camera, const Eigen::Vector2d& principal_point) {
  Pinhole base = pinhole_from_hfov(1392, 512, 1);
  double wide = 0.5 * camera.fx, narrow = camera.fx;
  for (int i = 0; i < 60; ++i) {
    base.fx = base.fy = 0.5 * (wide + narrow);
    const double final_fx = base.fx * border_free_zoom(camera.lens, base, principal_point);
    (final_fx > camera.fx ? narrow : wide) = base.fx;
  }
  return base;
}

double half_diagonal(const Pinhole& camera) {
  return 0.5 * frame_on_plane(camera).diagonal().norm();
}

/// Difference between two lenses over the frame, root mean square, pixels of 1392 × 512.
double difference_px(const Distortion& a, const Distortion& b, const Eigen::AlignedBox2d& frame) {
  double sum = 0;
  int points = 0;
  for (int y = -4; y <= 4; ++y)
    for (int x = -8; x <= 8; ++x, ++points) {
      const Eigen::Vector2d ideal(frame.max().x() * x / 8, frame.max().y() * y / 4);
      sum += (distort(a, ideal) - distort(b, ideal)).squaredNorm();
    }
  return std::sqrt(sum / points) * std::hypot(696, 256);
}

}  // namespace

TEST_CASE("the default bounds contain the lenses of KITTI's four cameras") {
  for (const KittiCamera& camera : kitti)
    CHECK(is_within({}, camera.lens, frame_on_plane(base_of(camera, centre))));
}

TEST_CASE(
    "with their principal points, KITTI's cameras 0 and 1 are within the default bounds, 2 within the "
    "recipe's") {
  // The farther the principal point from the centre, the larger the base that covers the far corner.
  const auto frame = [](const KittiCamera& c) { return frame_on_plane(base_of(c, {c.cx, c.cy})); };
  CHECK(is_within({}, kitti[0].lens, frame(kitti[0])));
  CHECK(is_within({}, kitti[1].lens, frame(kitti[1])));
  CHECK_FALSE(is_within({}, kitti[2].lens, frame(kitti[2])));
  CHECK(is_within({.min_eigenvalue = 0.08}, kitti[2].lens, frame(kitti[2])));
  const PrincipalPointBounds shift;
  for (const KittiCamera& camera : kitti) {
    CHECK(std::abs(camera.cx - centre.x()) < shift.max_shift_x * 1392);
    CHECK(std::abs(camera.cy - centre.y()) < shift.max_shift_y * 512);
  }
}

TEST_CASE("KITTI's lenses lie where the shape prior has ordinary density") {
  Pinhole unit = pinhole_from_hfov(1392, 512, 1);
  unit.fx = unit.fy = unit.fx * half_diagonal(unit);
  const Eigen::AlignedBox2d frame = frame_on_plane(unit);
  std::vector<Distortion> draws;
  for (int i = 0; draws.size() < 3000; ++i) {
    const Stream stream = substream(make_stream(1, "density"), i);
    auto lens = radial_lens(draw_shape(stream));
    if (!lens) continue;
    const Eigen::Vector2d p = draw_tangential(LensBounds{}.max_tangential, make_stream(stream.key, "p"));
    lens->p1 = p[0];
    lens->p2 = p[1];
    if (is_within({}, *lens, frame)) draws.push_back(*lens);
  }
  const auto share_near = [&](const Distortion& lens) {
    return std::count_if(draws.begin(), draws.end(),
                         [&](const Distortion& other) { return difference_px(lens, other, frame) < 10; }) /
           static_cast<double>(draws.size());
  };
  std::vector<double> typical;
  for (int i = 0; i < 100; ++i) typical.push_back(share_near(draws[i]));
  std::nth_element(typical.begin(), typical.begin() + 50, typical.end());
  CHECK(typical[50] < 0.1);
  for (const KittiCamera& camera : kitti) {
    const Pinhole base = base_of(camera, centre);
    CHECK(share_near(rescaled(camera.lens, half_diagonal(base))) > 0.3 * typical[50]);
  }
}
