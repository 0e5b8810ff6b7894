#include "distortion/models/conversion/convert.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "distortion/models/certificate/model_certificate.h"
#include "distortion/models/conversion/convert_fit.h"
#include "distortion/models/conversion/convert_search.h"
#include "distortion/models/inverse/unproject.h"
#include "distortion/models/projection.h"
#include "numbers/angles.h"

namespace cps {
namespace {

constexpr double plane_limit_deg = 85;

bool is_of_the_plane(std::string_view family) {
  return family == "brown_conrady" || family == "rational";
}

/// The pixels of a grid over the frame whose rays lie in the region; all do if it is proved for the frame.
SeenRays seen_rays(const ModelCamera& camera, const RayRegion& region) {
  constexpr int side = 31;
  SeenRays seen{.rays = Eigen::Matrix3Xd(3, side * side), .pixels = Eigen::Matrix2Xd(2, side * side)};
  const Eigen::Vector2d last(camera.pinhole.width - 1, camera.pinhole.height - 1);
  Eigen::Index count = 0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const Eigen::Vector2d pixel = last.cwiseProduct(Eigen::Vector2d(column, row)) / (side - 1);
      const auto ray = unproject(camera.lens, region, to_plane(camera.pinhole, pixel));
      if (!ray) continue;
      seen.rays.col(count) = *ray;
      seen.pixels.col(count++) = pixel;
      seen.max_angle_rad = std::max(seen.max_angle_rad, std::atan2(ray->head<2>().norm(), ray->z()));
    }
  seen.rays.conservativeResize(3, count);
  seen.pixels.conservativeResize(2, count);
  return seen;
}

/// The lens in another family that contains it with the same normalised image: names that both have mean the
/// same there. Empty if there is none, or if it is not what is held.
std::optional<LensModel> contained(const LensModel& lens, std::string_view family,
                                   const HeldParameters& held) {
  // Brown–Conrady's k1 k2 k3 p1 p2 in all three; ξ and k4 k5 k6 are 0 in what they share.
  const auto holds_brown_conrady = [](std::string_view name) {
    return is_of_the_plane(name) || name == "unified_spherical";
  };
  const bool is_same = family_name(lens) == family;
  if (!is_same && !(holds_brown_conrady(family_name(lens)) && holds_brown_conrady(family))) return {};
  HeldParameters values;
  for (const auto& [name, value] : parameters(lens))
    if (is_same || value != 0) values[std::string(name)] = value;
  for (const auto& [name, value] : held) {
    const auto found = values.find(name);
    if ((found == values.end() ? 0 : found->second) != value) return {};
  }
  const auto known = parameters(lens_from_parameters(family, {}));
  for (const auto& [name, value] : values)
    if (std::none_of(known.begin(), known.end(), [&](const auto& other) { return other.first == name; }))
      return {};
  return lens_from_parameters(family, values);
}

bool is_in_frame(const Pinhole& camera, const Eigen::Vector2d& pixel) {
  return pixel.x() >= -0.5 && pixel.x() <= camera.width - 0.5 && pixel.y() >= -0.5 &&
         pixel.y() <= camera.height - 0.5;
}

/// How far the new camera, proved on `region`, is from the rays.
void measure(ConvertedCamera& result, const RayRegion& region, const SeenRays& seen) {
  const auto& [name, pinhole, lens] = result.camera;
  double sum_px2 = 0;
  int shown = 0;
  for (Eigen::Index i = 0; i < seen.rays.cols(); ++i) {
    const Eigen::Vector3d ray = seen.rays.col(i);
    const Eigen::Vector2d pixel = seen.pixels.col(i), found = to_pixel(pinhole, project(lens, ray).point);
    const double error_px2 = (found - pixel).squaredNorm();
    sum_px2 += error_px2;
    result.worst_px = std::max(result.worst_px, std::sqrt(error_px2));
    shown += contains(region, lens, ray) && is_in_frame(pinhole, found) ? 1 : 0;
    if (const auto other = unproject(lens, region, to_plane(pinhole, pixel)))
      result.worst_angle_rad =
          std::max(result.worst_angle_rad, std::atan2(ray.cross(*other).norm(), ray.dot(*other)));
  }
  const auto rays = static_cast<double>(seen.rays.cols());
  result.rms_px = std::sqrt(sum_px2 / rays);
  result.covered = shown / rays;
}

}  // namespace

ConvertedCamera convert(const ModelCamera& camera, std::string_view family,
                        const std::map<std::string, double>& held) {
  lens_from_parameters(family, held);  // throws where nothing can be found
  ConvertedCamera result{.camera = camera};
  const ModelCertificate proof = certify_frame(camera);
  if (!proof.valid) {
    result.why = proof.why;
    return result;
  }
  const SeenRays seen = seen_rays(camera, proof.region);
  if (const auto same = contained(camera.lens, family, held)) {
    result.camera.lens = *same;
  } else {
    if (is_of_the_plane(family) && seen.max_angle_rad >= radians(plane_limit_deg)) {
      result.why = fmt::format(
          "sees {:.1f} degrees off the axis; {} lenses must stay below {}: choose a family for wide lenses, "
          "such as kannala_brandt",
          degrees(seen.max_angle_rad), family, plane_limit_deg);
      return result;
    }
    const auto best = best_fit(camera, family, seen, held);
    if (!best) {
      result.why = fmt::format("sees {:.1f} degrees off the axis, where no {} lens was found that shows them",
                               degrees(seen.max_angle_rad), family);
      return result;
    }
    result.camera = *best;
  }
  const ModelCertificate new_proof = certify_frame(result.camera);
  if (!new_proof.valid) {
    result.why = fmt::format("the closest {} lens is not one-to-one on the frame: {}", family, new_proof.why);
    return result;
  }
  measure(result, new_proof.region, seen);
  return result;
}

}  // namespace cps
