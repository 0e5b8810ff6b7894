#pragma once

#include <array>
#include <cstddef>

/// Polynomials on an interval in Bernstein form (Bernstein 1912; Farouki 2012). On [0, 1] every value of a
/// polynomial is a convex combination of its Bernstein coefficients, so their minimum and maximum bound it.
namespace cps {

/// Homogeneous polynomial in (1−t, t): coefficient i belongs to (1−t)^(n−i) t^i, binomial included, so that
/// products are plain convolutions. Divided by binomials<n>[i] it is the Bernstein coefficient.
template <int n>
using Form = std::array<double, n + 1>;

template <std::size_t n, std::size_t m>
constexpr std::array<double, n + m - 1> operator*(const std::array<double, n>& a,
                                                  const std::array<double, m>& b) {
  std::array<double, n + m - 1> product{};
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) product[i + j] += a[i] * b[j];
  return product;
}

/// a + scale · b.
template <std::size_t n>
constexpr std::array<double, n> sum(const std::array<double, n>& a, double scale,
                                    const std::array<double, n>& b) {
  std::array<double, n> total{};
  for (std::size_t i = 0; i < n; ++i) total[i] = a[i] + scale * b[i];
  return total;
}

/// ((1−t) + t)^n = 1: multiplying by it raises the degree by n and keeps the polynomial.
template <int n>
inline constexpr Form<n> binomials = binomials<n - 1>* Form<1>{1, 1};
template <>
inline constexpr Form<0> binomials<0>{1};

}  // namespace cps
