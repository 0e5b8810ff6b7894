#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <set>

#include "renderer/math/fast_math.h"
#include "renderer/math/sobol.h"
#include "tests/renderer/statistics.h"

using namespace cps;

TEST_CASE("The second Sobol coordinate is the product of the index with its direction numbers") {
  // Joe & Kuo's second dimension: polynomial x + 1, m_1 = 1, so v_k = v_{k−1} ^ (v_{k−1} >> 1).
  std::uint32_t directions[32];
  directions[0] = 1u << 31;
  for (int k = 1; k < 32; ++k) directions[k] = directions[k - 1] ^ (directions[k - 1] >> 1);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const auto index = static_cast<std::uint32_t>(random_bits(make_stream(1, "index"), i));
    std::uint32_t expected = 0;
    for (int k = 0; k < 32; ++k) expected ^= (index >> k & 1) ? directions[k] : 0;
    REQUIRE(reverse_bits(sobol_1_reversed(index)) == expected);
  }
}

TEST_CASE("Every power-of-two run of samples is a (0,m,2)-net in every pair") {
  const auto padded = [](std::uint32_t set) { return [set](const SobolSample& s) { return s.pair(set); }; };
  const auto joint = [](std::uint32_t which) {
    return [which](const SobolSample& s) { return s.joint_pair(which); };
  };
  const std::function<Eigen::Vector2f(const SobolSample&)> pairs[] = {padded(0), padded(1), padded(17),
                                                                      joint(0), joint(1)};
  for (const auto& pair : pairs) {
    for (int m : {4, 6, 8}) {
      for (std::uint32_t run = 0; run < 3; ++run) {
        for (int bits_x = 0; bits_x <= m; ++bits_x) {
          std::set<std::pair<int, int>> boxes;
          for (std::uint32_t i = 0; i < 1u << m; ++i) {
            const Eigen::Vector2f p = pair(make_sobol_sample(5, 3, 4, (run << m) + i));
            boxes.emplace(static_cast<int>(std::ldexp(p.x(), bits_x)),
                          static_cast<int>(std::ldexp(p.y(), m - bits_x)));
          }
          REQUIRE(boxes.size() == 1u << m);
        }
      }
    }
  }
}

TEST_CASE("Every run of 4^m samples is a (0,m,4)-net in base 4 in the joint pairs") {
  for (int m = 1; m <= 4; ++m) {
    const std::uint32_t samples = 1u << (2 * m);
    for (std::uint32_t run : {0u, 1u, 2u, 65536 / samples - 1}) {
      // Boxes of 4^-m, cut into 4^a · 4^b · 4^c · 4^d parts along the axes.
      for (int a = 0; a <= m; ++a)
        for (int b = 0; a + b <= m; ++b)
          for (int c = 0; a + b + c <= m; ++c) {
            const int d = m - a - b - c;
            std::set<std::array<int, 4>> boxes;
            for (std::uint32_t i = 0; i < samples; ++i) {
              const SobolSample sample = make_sobol_sample(6, 1, 2, run * samples + i);
              const Eigen::Vector2f p = sample.joint_pair(0), q = sample.joint_pair(1);
              boxes.insert(
                  {static_cast<int>(std::ldexp(p.x(), 2 * a)), static_cast<int>(std::ldexp(p.y(), 2 * b)),
                   static_cast<int>(std::ldexp(q.x(), 2 * c)), static_cast<int>(std::ldexp(q.y(), 2 * d))});
            }
            REQUIRE(boxes.size() == samples);
          }
    }
  }
}

TEST_CASE("Scrambles are uniform over pixels, and independent of each other") {
  // One sample of each of many pixels: uniform in the square; and so are coordinates of different pairs
  // together.
  constexpr int cells = 16, pixels = 100000;
  std::vector<double> pair_counts(cells * cells), mixed_counts(cells * cells), joint_counts(cells * cells);
  const std::vector<double> expected(cells * cells, static_cast<double>(pixels) / (cells * cells));
  for (int i = 0; i < pixels; ++i) {
    const SobolSample sample = make_sobol_sample(7, i % 400, i / 400, 0);
    const Eigen::Vector2f a = sample.pair(2), b = sample.pair(3), c = sample.joint_pair(1);
    ++pair_counts[static_cast<int>(a.x() * cells) * cells + static_cast<int>(a.y() * cells)];
    ++mixed_counts[static_cast<int>(a.x() * cells) * cells + static_cast<int>(b.x() * cells)];
    ++joint_counts[static_cast<int>(c.x() * cells) * cells + static_cast<int>(c.y() * cells)];
  }
  CHECK(chi_squared_p_value(pair_counts, expected) > 1e-4);
  CHECK(chi_squared_p_value(joint_counts, expected) > 1e-4);
  CHECK(chi_squared_p_value(mixed_counts, expected) > 1e-4);
}

TEST_CASE("Pairs of one pixel do not move together") {
  // Padding would fail if two pairs visited their points in the same order: x of one would determine x of the
  // other.
  constexpr int cells = 8, samples = 4096;
  std::vector<double> counts(cells * cells);
  for (int i = 0; i < samples; ++i) {
    const SobolSample sample = make_sobol_sample(11, 20, 30, static_cast<std::uint32_t>(i));
    ++counts[static_cast<int>(sample.pair(1).x() * cells) * cells +
             static_cast<int>(sample.pair(2).x() * cells)];
  }
  CHECK(chi_squared_p_value(counts, std::vector<double>(cells * cells, samples / (cells * cells))) > 1e-4);
}

TEST_CASE("The inner loop's functions are as exact as they say") {
  for (int i = 0; i <= 100000; ++i) {
    const double t = i / 100000.0;
    const SinCos s = sincos_of_turns(static_cast<float>(t));
    const double angle = 2 * std::numbers::pi * static_cast<float>(t);
    REQUIRE(std::abs(s.sin - std::sin(angle)) < 4e-7);
    REQUIRE(std::abs(s.cos - std::cos(angle)) < 4e-7);
    const float turns = turns_of_vector(s.cos, s.sin);
    const double apart = std::abs(turns - t);
    REQUIRE(std::min(apart, 1 - apart) < 5e-7);
    const auto x = static_cast<float>(std::exp(40 * (t - 0.5)));
    REQUIRE(std::abs(log2_of(x) - std::log2(static_cast<double>(x))) < 5e-6);
  }
  CHECK(turns_of_vector(0, 0) == 0);
}
