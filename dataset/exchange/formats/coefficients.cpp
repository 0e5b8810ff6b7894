#include "dataset/exchange/formats/coefficients.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace cps {
namespace {

constexpr std::array plane_names{"k1", "k2", "p1", "p2", "k3", "k4",    "k5",
                                 "k6", "s1", "s2", "s3", "s4", "tau_x", "tau_y"};

void check_count(std::span<const double> values, std::size_t most, const std::string& where) {
  if (values.size() > most)
    throw std::runtime_error(where + ": has more than " + std::to_string(most) + " coefficients");
}

void refuse_beyond(std::span<const double> values, std::size_t count, const std::string& model,
                   const std::string& where) {
  for (std::size_t i = count; i < values.size(); ++i)
    if (values[i] != 0)
      throw std::runtime_error(where + ": " + plane_names[i] + " is not 0, which " + model +
                               " does not have: calibrate without it");
}

/// The first four of a list whose others are 0.
std::span<const double> four(std::span<const double> values, const std::string& names,
                             const std::string& where) {
  check_count(values, plane_names.size(), where);
  const bool rest_is_zero = std::all_of(values.begin() + std::min<std::ptrdiff_t>(4, std::ssize(values)),
                                        values.end(), [](double value) { return value == 0; });
  if (values.size() < 4 || !rest_is_zero)
    throw std::runtime_error(where + ": must be the 4 numbers " + names + " of the lens model that is named");
  return values.first(4);
}

}  // namespace

Distortion brown_conrady_lens(std::span<const double> values, const std::string& where) {
  check_count(values, plane_names.size(), where);
  refuse_beyond(values, 5, "Brown-Conrady (k1 k2 p1 p2 k3)", where);
  const auto at = [&](std::size_t i) { return i < values.size() ? values[i] : 0.0; };
  return {.k1 = at(0), .k2 = at(1), .k3 = at(4), .p1 = at(2), .p2 = at(3)};
}

LensModel plane_lens(std::span<const double> values, const std::string& where) {
  check_count(values, plane_names.size(), where);
  const std::span<const double> denominator =
      values.subspan(std::min<std::size_t>(5, values.size()),
                     std::min<std::size_t>(8, values.size()) - std::min<std::size_t>(5, values.size()));
  if (std::all_of(denominator.begin(), denominator.end(), [](double value) { return value == 0; }))
    return brown_conrady_lens(values, where);
  if (values.size() < 8) throw std::runtime_error(where + ": k4 k5 k6 must be given together");
  refuse_beyond(values, 8, "the rational model (k1 … k6, p1, p2)", where);
  return RationalLens{.k1 = values[0],
                      .k2 = values[1],
                      .k3 = values[4],
                      .k4 = values[5],
                      .k5 = values[6],
                      .k6 = values[7],
                      .p1 = values[2],
                      .p2 = values[3]};
}

KannalaBrandt kannala_brandt_lens(std::span<const double> values, const std::string& where) {
  const std::span<const double> k = four(values, "k1 k2 k3 k4", where);
  return {.k1 = k[0], .k2 = k[1], .k3 = k[2], .k4 = k[3]};
}

UnifiedSpherical unified_spherical_lens(double xi, std::span<const double> values, const std::string& where) {
  return {.xi = xi, .distortion = brown_conrady_lens(four(values, "k1 k2 p1 p2", where), where)};
}

std::vector<double> opencv_coefficients(const LensModel& lens) {
  if (const auto* k = std::get_if<RationalLens>(&lens))
    return {k->k1, k->k2, k->p1, k->p2, k->k3, k->k4, k->k5, k->k6};
  if (const auto* k = std::get_if<KannalaBrandt>(&lens)) return {k->k1, k->k2, k->k3, k->k4};
  if (const auto* sphere = std::get_if<UnifiedSpherical>(&lens)) {
    const Distortion& k = sphere->distortion;
    return {k.k1, k.k2, k.p1, k.p2};
  }
  if (const auto* k = std::get_if<Distortion>(&lens)) return {k->k1, k->k2, k->p1, k->p2, k->k3};
  return {};
}

}  // namespace cps
