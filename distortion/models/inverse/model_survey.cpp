#include "distortion/models/inverse/model_survey.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>

#include <algorithm>
#include <cmath>

#include "distortion/models/inverse/region_inverse.h"
#include "distortion/models/projection.h"

namespace cps {
namespace {

ModelSurvey joined(const ModelSurvey& a, const ModelSurvey& b) {
  return {.pixels = a.pixels + b.pixels,
          .outside = a.outside + b.outside,
          .worst_residual_px = std::max(a.worst_residual_px, b.worst_residual_px)};
}

template <typename Lens>
ModelSurvey survey(const Pinhole& camera, const Lens& lens, const RayRegion& region) {
  constexpr double max_pixels = 1e6;
  const int step = std::max(1, int(std::sqrt(double(camera.width) * camera.height / max_pixels)));
  const RegionInverse<Lens> inverse(lens, region);
  const Eigen::Vector2d focal(camera.fx, camera.fy);
  return tbb::parallel_reduce(
      tbb::blocked_range<int>(0, (camera.height + step - 1) / step), ModelSurvey{},
      [&](const tbb::blocked_range<int>& range, ModelSurvey found) {
        for (int row = range.begin(); row < range.end(); ++row)
          for (int x = 0; x < camera.width; x += step) {
            const Eigen::Vector2d point = to_plane(camera, {x, row * step});
            ++found.pixels;
            const auto ray = inverse(point);
            if (!ray) {
              ++found.outside;
              continue;
            }
            const double residual_px = (project(lens, *ray).point - point).cwiseProduct(focal).norm();
            found.worst_residual_px = std::max(found.worst_residual_px, residual_px);
          }
        return found;
      },
      joined);
}

}  // namespace

ModelSurvey survey_inversion(const ModelCamera& camera, const RayRegion& region) {
  return std::visit([&](const auto& lens) { return survey(camera.pinhole, lens, region); }, camera.lens);
}

}  // namespace cps
