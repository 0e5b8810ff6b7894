#include "trainer/images/orientation/tilt_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace cps {
namespace {

using Terms = Eigen::Matrix<double, tilt_terms, 1>;
using Square = Eigen::Matrix<double, tilt_terms, tilt_terms>;

constexpr double prior_deviation = .5;

/// Variance of a cell's tilt in a picture whose edges fit exactly: what 8 bits and 3×3 pixels leave.
constexpr double smallest_variance = 1e-4;

/// The centres of an axis' cells, from the picture's centre, in half diagonals.
std::vector<double> centres(int pixels, int cells, double half_diagonal) {
  std::vector<double> result(cells);
  for (int i = 0; i < cells; ++i) result[i] = ((i + .5) / cells - .5) * pixels / half_diagonal;
  return result;
}

Terms terms_at(double x, double y) {
  return (Terms() << 1, x, y, x * y, x * x, y * y).finished();
}

/// Sums over the cells.
struct Moments {
  Square normal = Square::Zero();  ///< Σ steep · terms termsᵀ
  Terms right = Terms::Zero();     ///< Σ product · terms
  double steep = 0, steep_squares = 0, product = 0, flat = 0;
};

Moments moments_of(const EdgeCells& cells, int family) {
  const double width = cells.picture.width, height = cells.picture.height,
               half_diagonal = std::sqrt(width * width + height * height) / 2;
  const std::vector<double> xs = centres(cells.picture.width, cells.grid.width, half_diagonal),
                            ys = centres(cells.picture.height, cells.grid.height, half_diagonal);
  Moments sums;
  const EdgeTensor* tensor = cells.families[family].data();
  for (double y : ys)
    for (double x : xs) {
      const EdgeTensor& t = *tensor++;
      if (t.steep == 0) continue;
      const double agreement = coherence(t), steep = agreement * static_cast<double>(t.steep),
                   product = agreement * static_cast<double>(t.product);
      const Terms terms = terms_at(x, y);
      sums.normal += steep * terms * terms.transpose();
      sums.right += product * terms;
      sums.steep += steep;
      sums.steep_squares += steep * steep;
      sums.product += product;
      sums.flat += agreement * static_cast<double>(t.flat);
    }
  return sums;
}

}  // namespace

TiltFit fit_tilt(const EdgeCells& cells, int family) {
  TiltFit fit;
  fit.errors.fill(prior_deviation);
  const Moments sums = moments_of(cells, family);
  if (sums.steep == 0) return fit;
  const Square normal = sums.normal / sums.steep;
  const Terms right = sums.right / sums.steep;
  const double count = sums.steep * sums.steep / sums.steep_squares;
  const double mean = sums.product / sums.steep, mean_square = sums.flat / sums.steep;
  const double spread = std::max(0.0, mean_square - mean * mean) + smallest_variance;
  const Square with_prior =
      normal + spread / (count * prior_deviation * prior_deviation) * Square::Identity();
  const Eigen::LLT<Square> factor(with_prior);
  const Terms coefficients = factor.solve(right);
  const Square inverse = factor.solve(Square::Identity());

  // Σ weight · (tilt − fit)² over the pixels, whose fit is their cell's.
  const double residual =
      std::max(0.0, mean_square - 2 * coefficients.dot(right) + coefficients.dot(normal * coefficients));
  for (int i = 0; i < tilt_terms; ++i) {
    fit.coefficients[i] = coefficients[i];
    fit.errors[i] =
        std::min(prior_deviation, std::sqrt((residual + smallest_variance) * inverse(i, i) / count));
  }
  fit.share = sums.steep / static_cast<double>(cells.energy);
  fit.residual = std::sqrt(residual);
  return fit;
}

}  // namespace cps
