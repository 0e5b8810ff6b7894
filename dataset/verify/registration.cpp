#include "dataset/verify/registration.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace cps {
namespace {

struct Picture {
  int width = 0, height = 0;
  std::vector<float> values;
  float at(int x, int y) const { return values[static_cast<std::size_t>(y) * width + x]; }
};

Picture copy_of(const OIIO::ImageBuf& image) {
  Picture picture{image.spec().width, image.spec().height, {}};
  const auto* pixels = static_cast<const float*>(image.localpixels());
  picture.values.assign(pixels, pixels + static_cast<std::size_t>(picture.width) * picture.height);
  return picture;
}

/// Smoothed by (1 4 6 4 1)/16 along each axis; pixels of the rim are repeated outward.
Picture smoothed(const Picture& from) {
  constexpr float weights[] = {1 / 16.f, 4 / 16.f, 6 / 16.f, 4 / 16.f, 1 / 16.f};
  Picture rows = from, both = from;
  for (int y = 0; y < from.height; ++y)
    for (int x = 0; x < from.width; ++x) {
      float sum = 0;
      for (int i = -2; i <= 2; ++i) sum += weights[i + 2] * from.at(std::clamp(x + i, 0, from.width - 1), y);
      rows.values[static_cast<std::size_t>(y) * from.width + x] = sum;
    }
  for (int y = 0; y < from.height; ++y)
    for (int x = 0; x < from.width; ++x) {
      float sum = 0;
      for (int i = -2; i <= 2; ++i) sum += weights[i + 2] * rows.at(x, std::clamp(y + i, 0, from.height - 1));
      both.values[static_cast<std::size_t>(y) * from.width + x] = sum;
    }
  return both;
}

struct Shift {
  Eigen::Vector2d px = Eigen::Vector2d::Zero();
  double noise_px = INFINITY;
};

struct Region {
  int x0, y0, x1, y1;  ///< exclusive at the end
};

/// After the binomial kernel neighbouring differences are not independent: this many pixels count as one
/// sample (per axis 1 / Σ w² = 256/70).
constexpr double pixels_per_sample = (256.0 / 70) * (256.0 / 70);

Shift shift_of(const Picture& a, const Picture& b, const Region& region) {
  std::vector<double> differences;
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) differences.push_back(std::abs(b.at(x, y) - a.at(x, y)));
  if (differences.size() < 64) return {};
  const auto middle = differences.begin() + static_cast<std::ptrdiff_t>(differences.size() / 2);
  std::nth_element(differences.begin(), middle, differences.end());
  const double limit = 3 * *middle + 1e-6;

  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  double square = 0;
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) {
      const Eigen::Vector2d gradient(
          0.25 * (a.at(x + 1, y) - a.at(x - 1, y) + b.at(x + 1, y) - b.at(x - 1, y)),
          0.25 * (a.at(x, y + 1) - a.at(x, y - 1) + b.at(x, y + 1) - b.at(x, y - 1)));
      const double difference = b.at(x, y) - a.at(x, y);
      const double weight = std::min(1.0, limit / (std::abs(difference) + 1e-12));
      normal += weight * gradient * gradient.transpose();
      right -= weight * difference * gradient;  // b(x) = a(x − shift): b − a = −gradient · shift
      square += weight * difference * difference;
    }
  const auto count = static_cast<double>(differences.size());
  const Eigen::LDLT<Eigen::Matrix2d> solver(normal);
  if (normal.determinant() <= 1e-12 * normal.trace() * normal.trace()) return {};
  const Eigen::Matrix2d covariance = square / count * pixels_per_sample * normal.inverse();
  return {.px = solver.solve(right), .noise_px = std::sqrt(covariance.trace())};
}

/// Sums of squares and products about the means of one region.
struct Moments {
  double aa = 0, bb = 0, ab = 0;
};

Moments moments_of(const Picture& a, const Picture& b, const Region& region) {
  double count = 0, sum_a = 0, sum_b = 0;
  Moments sums;
  for (int y = region.y0; y < region.y1; ++y)
    for (int x = region.x0; x < region.x1; ++x) {
      const double va = a.at(x, y), vb = b.at(x, y);
      ++count, sum_a += va, sum_b += vb;
      sums.aa += va * va, sums.bb += vb * vb, sums.ab += va * vb;
    }
  if (count == 0) return {};
  return {sums.aa - sum_a * sum_a / count, sums.bb - sum_b * sum_b / count, sums.ab - sum_a * sum_b / count};
}

}  // namespace

Registration register_pictures(const OIIO::ImageBuf& first, const OIIO::ImageBuf& second,
                               const RegistrationOptions& options) {
  const OIIO::ImageSpec &one = first.spec(), &two = second.spec();
  if (one.width != two.width || one.height != two.height || one.nchannels != 1 || two.nchannels != 1)
    throw std::runtime_error("registration: needs two pictures of one channel and one size");
  const Picture raw_a = copy_of(first), raw_b = copy_of(second), a = smoothed(raw_a), b = smoothed(raw_b);
  Registration result;
  double square = 0;
  for (std::size_t i = 0; i < raw_a.values.size(); ++i) {
    const double difference = raw_b.values[i] - raw_a.values[i];
    square += difference * difference;
  }
  result.psnr_db = -10 * std::log10(std::max(square / static_cast<double>(raw_a.values.size()), 1e-12));

  constexpr int rim = 3;  // the smoothing repeats pixels there
  const Region inside{rim, rim, a.width - rim, a.height - rim};
  const Shift whole = shift_of(a, b, inside);
  result.shift_x_px = whole.px.x();
  result.shift_y_px = whole.px.y();
  result.shift_noise_px = whole.noise_px;
  const int across = std::max(1, (inside.x1 - inside.x0) / options.block_px);
  const int down = std::max(1, (inside.y1 - inside.y0) / options.block_px);
  double sum = 0;
  Moments all;
  for (int j = 0; j < down; ++j)
    for (int i = 0; i < across; ++i) {
      const auto part = [](int begin, int end, int k, int n) { return begin + (end - begin) * k / n; };
      const Region region{part(inside.x0, inside.x1, i, across), part(inside.y0, inside.y1, j, down),
                          part(inside.x0, inside.x1, i + 1, across), part(inside.y0, inside.y1, j + 1, down)};
      const Moments moments = moments_of(a, b, region);
      all.aa += moments.aa, all.bb += moments.bb, all.ab += moments.ab;
      const Shift block = shift_of(a, b, region);
      if (!(block.noise_px < options.max_noise_px)) continue;
      const double beyond_noise = block.px.squaredNorm() - block.noise_px * block.noise_px;
      sum += beyond_noise;
      ++result.blocks;
      result.worst_block_px = std::max(result.worst_block_px, std::sqrt(std::max(0.0, beyond_noise)));
    }
  if (all.aa > 0 && all.bb > 0) result.correlation = all.ab / std::sqrt(all.aa * all.bb);
  if (result.blocks > 0) result.block_rms_px = std::sqrt(std::max(0.0, sum / result.blocks));
  return result;
}

}  // namespace cps
