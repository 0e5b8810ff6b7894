#include <catch2/catch.hpp>
#include <opencv2/calib3d.hpp>
#include <optional>

#include "distortion/models/projection.h"
#include "tests/distortion/models/random_models.h"

using namespace cps;

namespace {

/// The published formulas, written out independently: see each family's file for the source.
cv::Point2d distorted_by_opencv(const std::vector<double>& coefficients, double x, double y) {
  std::vector<cv::Point2d> image;
  cv::projectPoints(std::vector<cv::Point3d>{{x, y, 1}}, cv::Vec3d(), cv::Vec3d(), cv::Matx33d::eye(),
                    coefficients, image);
  return image[0];
}

Eigen::Vector2d published(const Distortion& l, const Eigen::Vector3d& ray) {
  const cv::Point2d p =
      distorted_by_opencv({l.k1, l.k2, l.p1, l.p2, l.k3}, ray.x() / ray.z(), ray.y() / ray.z());
  return {p.x, p.y};
}

Eigen::Vector2d published(const RationalLens& l, const Eigen::Vector3d& ray) {
  const cv::Point2d p = distorted_by_opencv({l.k1, l.k2, l.p1, l.p2, l.k3, l.k4, l.k5, l.k6},
                                            ray.x() / ray.z(), ray.y() / ray.z());
  return {p.x, p.y};
}

Eigen::Vector2d published(const KannalaBrandt& l, const Eigen::Vector3d& ray) {
  if (ray.z() > 0) {
    std::vector<cv::Point2d> image;
    cv::fisheye::projectPoints(std::vector<cv::Point3d>{{ray.x(), ray.y(), ray.z()}}, image, cv::Vec3d(),
                               cv::Vec3d(), cv::Matx33d::eye(), cv::Vec4d(l.k1, l.k2, l.k3, l.k4));
    return {image[0].x, image[0].y};
  }
  // OpenCV's function divides by z and so knows the front half only.
  const double theta = std::atan2(std::hypot(ray.x(), ray.y()), ray.z()),
               around = std::atan2(ray.y(), ray.x());
  const double r = theta + l.k1 * std::pow(theta, 3) + l.k2 * std::pow(theta, 5) + l.k3 * std::pow(theta, 7) +
                   l.k4 * std::pow(theta, 9);
  return {r * std::cos(around), r * std::sin(around)};
}

Eigen::Vector2d published(const UnifiedSpherical& l, const Eigen::Vector3d& ray) {
  const Eigen::Vector3d from_centre = ray / ray.norm() + Eigen::Vector3d(0, 0, l.xi);
  const Distortion& d = l.distortion;
  const cv::Point2d p = distorted_by_opencv({d.k1, d.k2, d.p1, d.p2, d.k3}, from_centre.x() / from_centre.z(),
                                            from_centre.y() / from_centre.z());
  return {p.x, p.y};
}

Eigen::Vector2d published(const Eucm& l, const Eigen::Vector3d& ray) {
  const double x = ray.x(), y = ray.y(), z = ray.z();
  const double denominator = l.alpha * std::sqrt(l.beta * (x * x + y * y) + z * z) + (1 - l.alpha) * z;
  return {x / denominator, y / denominator};
}

Eigen::Vector2d published(const DoubleSphere& l, const Eigen::Vector3d& ray) {
  const double x = ray.x(), y = ray.y(), z = ray.z(), d1 = std::sqrt(x * x + y * y + z * z);
  const double d2 = std::sqrt(x * x + y * y + (l.xi * d1 + z) * (l.xi * d1 + z));
  const double denominator = l.alpha * d2 + (1 - l.alpha) * (l.xi * d1 + z);
  return {x / denominator, y / denominator};
}

Eigen::Vector2d published(const LensModel& lens, const Eigen::Vector3d& ray) {
  return std::visit([&](const auto& family) { return published(family, ray); }, lens);
}

/// A ray of a random length well inside the angles where the family's formula holds. Rays that a lens throws
/// far out are of no use here: rounding grows with the distance.
std::optional<Eigen::Vector3d> usable_ray(const LensModel& lens, Stream stream, double far) {
  const bool is_plane = lens.index() < 2;
  const double angle = random_uniform(stream, 0, 0, is_plane ? 1.2 : 0.95 * angle_limit(lens));
  const Eigen::Vector3d ray = random_uniform(stream, 1, 0.1, 10) * random_ray(stream, 2, angle);
  if (published(lens, ray).norm() < far) return ray;
  return {};
}

}  // namespace

TEST_CASE("projections agree with OpenCV and the published formulas to 1e-12") {
  for (std::size_t family = 0; family < std::variant_size_v<LensModel>; ++family) {
    const Stream stream = make_stream(family, "published projections");
    double worst = 0;
    int tried = 0;
    for (int i = 0; i < 4000; ++i) {
      const LensModel lens = random_model(family, stream, i);
      const auto ray = usable_ray(lens, substream(stream, ~i), 50);
      if (!ray) continue;
      const Eigen::Vector2d theirs = published(lens, *ray);
      worst = std::max(worst, (project(lens, *ray).point - theirs).norm() / (1 + theirs.norm()));
      ++tried;
    }
    INFO(family_names()[family]);
    CHECK(worst < 1e-12);
    CHECK(tried > 3000);
  }
}

TEST_CASE("projection Jacobians are the derivatives, and 0 along the ray") {
  for (std::size_t family = 0; family < std::variant_size_v<LensModel>; ++family) {
    const Stream stream = make_stream(family, "projection jacobians");
    double worst = 0, along = 0;
    int tried = 0;
    for (int i = 0; i < 2000; ++i) {
      const LensModel lens = random_model(family, stream, i);
      const auto drawn = usable_ray(lens, substream(stream, ~i), 5);
      if (!drawn) continue;
      const Eigen::Vector3d ray = *drawn / drawn->norm();
      const ProjectedRay at = project(lens, ray);
      if (at.jacobian.norm() > 50) continue;  // too steep for differences
      constexpr double h = 1e-5;
      Eigen::Matrix<double, 2, 3> difference;
      for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(axis);
        difference.col(axis) = (project(lens, ray + step).point - project(lens, ray - step).point) / (2 * h);
      }
      worst = std::max(worst, (at.jacobian - difference).norm() / (1 + at.jacobian.squaredNorm()));
      along = std::max(along, (at.jacobian * ray).norm() / (1 + at.jacobian.norm()));
      ++tried;
    }
    INFO(family_names()[family]);
    CHECK(worst < 1e-7);
    CHECK(along < 1e-13);
    CHECK(tried > 1000);
  }
}

TEST_CASE("near the axis projection is exact, and its Jacobian a scale") {
  const double scale_of[] = {1, 1, 1, 1 / 2.5, 1, 1 / 1.25};  // eucm: 1 / (α + 1 − α)
  const std::vector<LensModel> lenses{Distortion{.k1 = -0.3},
                                      RationalLens{.k1 = 0.2, .k4 = 0.1},
                                      KannalaBrandt{.k1 = -0.05, .k2 = 0.01},
                                      UnifiedSpherical{.xi = 1.5, .distortion = {.k1 = -0.3}},
                                      Eucm{.alpha = 0.6, .beta = 1.2},
                                      DoubleSphere{.xi = 0.25, .alpha = 0.6}};
  for (const LensModel& lens : lenses)
    for (const double across : {0.0, 1e-300, 1e-150, 1e-9}) {
      const double scale = scale_of[lens.index()];
      const ProjectedRay at = project(lens, {2 * 0.6 * across, 2 * 0.8 * across, 2});
      INFO(description(lens) << ", " << across);
      CHECK((at.point - across * scale * Eigen::Vector2d(0.6, 0.8)).norm() <= 2e-15 * across);
      Eigen::Matrix<double, 2, 3> expected;
      expected << scale / 2, 0, 0, 0, scale / 2, 0;
      CHECK((at.jacobian - expected).norm() < 1e-8);
    }
}

TEST_CASE("a length does not change a projection") {
  for (std::size_t family = 0; family < std::variant_size_v<LensModel>; ++family) {
    const LensModel lens = random_model(family, make_stream(5, "lengths"), 3);
    const Eigen::Vector3d ray(0.3, -0.2, 0.9);
    for (const double length : {1e-60, 1e-3, 1e60})
      CHECK((project(lens, length * ray).point - project(lens, ray).point).norm() < 1e-14);
  }
}
