#include <catch2/catch.hpp>
#include <opencv2/calib3d.hpp>

#include "tests/distortion/random_lens.h"

using namespace cps;

TEST_CASE("distortion agrees with OpenCV's projectPoints to 1e-12") {
  const Stream stream = make_stream(1, "opencv");
  double worst = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const Distortion lens = wild_lens(stream, i, camera);
    const Eigen::Vector2d ideal = random_point(substream(stream, i), 0, frame_on_plane(camera));
    std::vector<cv::Point3d> points{{ideal.x(), ideal.y(), 1}};
    std::vector<cv::Point2d> image;
    cv::projectPoints(points, cv::Vec3d(), cv::Vec3d(), cv::Matx33d::eye(),
                      std::vector<double>{lens.k1, lens.k2, lens.p1, lens.p2, lens.k3}, image);
    const Eigen::Vector2d theirs(image[0].x, image[0].y);
    worst = std::max(worst, (distort(lens, ideal) - theirs).norm() / (1 + theirs.norm()));
  }
  CHECK(worst < 1e-12);
}

TEST_CASE("the Jacobian is the derivative of the distortion") {
  const Stream stream = make_stream(2, "jacobian");
  for (int i = 0; i < 500; ++i) {
    const Pinhole camera = random_camera(stream, i);
    const Distortion lens = wild_lens(stream, i, camera);
    const Eigen::Vector2d at = random_point(substream(stream, i), 0, frame_on_plane(camera));
    const double h = 1e-5 * (1 + at.norm());
    Eigen::Matrix2d difference;
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d step = h * Eigen::Vector2d::Unit(axis);
      difference.col(axis) = (distort(lens, at + step) - distort(lens, at - step)) / (2 * h);
    }
    const Eigen::Matrix2d jacobian = distortion_jacobian(lens, at);
    CHECK((jacobian - difference).norm() < 1e-7 * (1 + jacobian.norm()));
  }
}

TEST_CASE("rescaled coefficients are the same lens in other units") {
  const Distortion lens{-0.3, 0.1, 0.02, 0.004, -0.003};
  const Eigen::Vector2d at(0.5, -0.7);
  const double unit = 1.7;
  CHECK((distort(rescaled(lens, unit), at / unit) * unit - distort(lens, at)).norm() < 1e-15);
}
