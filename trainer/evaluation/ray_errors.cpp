#include "trainer/evaluation/ray_errors.h"

#include <Eigen/SVD>
#include <cmath>
#include <vector>

#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/inverse/unproject.h"
#include "distortion/models/projection.h"
#include "distortion/models/warp/proved_camera.h"
#include "distortion/models/warp/seen_hfov.h"
#include "numbers/angles.h"
#include "numbers/quantile.h"

namespace cps {
namespace {

double angle_deg(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return degrees(std::atan2(a.cross(b).norm(), a.dot(b)));
}

std::optional<RayAngles> pixel_angles(const RayTruth& truth, const ModelCamera& predicted,
                                      const ModelCertificate& proof) {
  if (!proof.valid) return std::nullopt;
  std::vector<Eigen::Vector3d> rays;
  for (const Eigen::Vector2d& pixel : truth.pixels) {
    const auto ray = unproject(predicted.lens, proof.region, to_plane(predicted.pinhole, pixel));
    if (!ray) return std::nullopt;
    rays.push_back(*ray);
  }
  return angles_between(truth.rays, rays);
}

std::optional<double> mean_distance_px(const RayTruth& truth, const ModelCamera& predicted) {
  const double limit_rad = angle_limit(predicted.lens);
  double sum = 0;
  for (std::size_t i = 0; i < truth.pixels.size(); ++i) {
    const Eigen::Vector3d& ray = truth.rays[i];
    if (!(std::atan2(ray.head<2>().norm(), ray.z()) < limit_rad)) return std::nullopt;
    const Eigen::Vector2d shown = to_pixel(predicted.pinhole, project(predicted.lens, ray).point);
    sum += (shown - truth.pixels[i]).norm();
  }
  return sum / static_cast<double>(truth.pixels.size());
}

}  // namespace

Eigen::Matrix3d nearest_rotation(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < from.size(); ++i) sum += to[i] * from[i].transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  // Of the orthogonal matrices the nearest that is no reflection.
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0 ? -1 : 1;
  return svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

RayAngles angles_between(std::span<const Eigen::Vector3d> truth, std::span<const Eigen::Vector3d> predicted) {
  const Eigen::Matrix3d turn = nearest_rotation(predicted, truth);
  const double n = static_cast<double>(truth.size());
  RayAngles angles;
  std::vector<double> all_deg;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    all_deg.push_back(angle_deg(truth[i], predicted[i]));
    angles.mean_deg += all_deg.back() / n;
    angles.turned_mean_deg += angle_deg(truth[i], turn * predicted[i]) / n;
  }
  angles.p95_deg = quantile(all_deg, .95);
  return angles;
}

RayErrors ray_errors(const RayTruth& truth, const std::optional<ModelCamera>& predicted) {
  RayErrors errors;
  if (!predicted) return errors;
  const ModelCertificate proof = certify_frame(*predicted);
  errors.angles = pixel_angles(truth, *predicted, proof);
  errors.reprojection_px = mean_distance_px(truth, *predicted);
  if (!is_empty(proof.region) && truth.seen_hfov_rad)
    if (const std::optional<double> seen = seen_hfov_rad(*predicted, proof.region))
      errors.seen_hfov_deg = degrees(std::abs(*seen - *truth.seen_hfov_rad));
  return errors;
}

}  // namespace cps
