#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/models/conversion/parameter_jacobian.h"
#include "distortion/models/projection.h"

using namespace cps;

TEST_CASE("derivatives by a lens' parameters are the differences of its projection") {
  const std::vector<LensModel> lenses{
      Distortion{-0.3, 0.1, -0.02, 0.002, -0.001},
      RationalLens{0.3, 0.1, 0.02, 0.5, 0.2, 0.01, 0.002, -0.001},
      KannalaBrandt{-0.02, 0.003, -0.001, 0.0001},
      UnifiedSpherical{.xi = 0.9, .distortion = {-0.1, 0.2, 0.05, 0.001, -0.003}},
      Eucm{.alpha = 0.6, .beta = 1.2},
      DoubleSphere{.xi = -0.2, .alpha = 0.6}};
  for (const LensModel& lens : lenses) {
    const auto known = parameters(lens);
    for (const Eigen::Vector3d& ray : {Eigen::Vector3d(0.3, -0.5, 1), Eigen::Vector3d(-2, 1, 2.5),
                                       Eigen::Vector3d(0, 0, 3), Eigen::Vector3d(0.01, 0.02, 0.7)}) {
      const ParameterJacobian jacobian = parameter_jacobian(lens, ray);
      REQUIRE(jacobian.cols() == static_cast<Eigen::Index>(known.size()));
      for (std::size_t i = 0; i < known.size(); ++i) {
        constexpr double step = 1e-5;
        const auto moved = [&](double by) {
          std::map<std::string, double> values(known.begin(), known.end());
          values[std::string(known[i].first)] += by;
          return project(lens_from_parameters(family_name(lens), values), ray).point;
        };
        const Eigen::Vector2d difference = (moved(step) - moved(-step)) / (2 * step);
        INFO(description(lens) << ", by " << known[i].first << " at " << ray.transpose());
        CHECK((jacobian.col(i) - difference).norm() < 1e-8 * (1 + difference.norm()));
      }
    }
  }
}
