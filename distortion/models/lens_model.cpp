#include "distortion/models/lens_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace cps {
namespace {

/// The families in the order of LensModel, each with its defaults.
constexpr std::array<std::pair<std::string_view, LensModel>, std::variant_size_v<LensModel>> families{
    {{"brown_conrady", Distortion{}},
     {"rational", RationalLens{}},
     {"kannala_brandt", KannalaBrandt{}},
     {"unified_spherical", UnifiedSpherical{}},
     {"eucm", Eucm{}},
     {"double_sphere", DoubleSphere{}}}};

struct Range {
  std::string_view text;
  bool (*contains)(double);
};
constexpr Range any{"any number", [](double) { return true; }};
constexpr Range not_negative{"at least 0", [](double value) { return value >= 0; }};
constexpr Range positive{"above 0", [](double value) { return value > 0; }};
constexpr Range zero_to_one{"between 0 and 1", [](double value) { return value >= 0 && value <= 1; }};
constexpr Range above_minus_one_to_one{"above -1 and at most 1",
                                       [](double value) { return value > -1 && value <= 1; }};

struct Parameter {
  std::string_view name;
  double* value;
  Range range = any;
};

std::vector<Parameter> named(Distortion& lens) {
  return {{"k1", &lens.k1}, {"k2", &lens.k2}, {"k3", &lens.k3}, {"p1", &lens.p1}, {"p2", &lens.p2}};
}

std::vector<Parameter> named(RationalLens& lens) {
  return {{"k1", &lens.k1}, {"k2", &lens.k2}, {"k3", &lens.k3}, {"k4", &lens.k4},
          {"k5", &lens.k5}, {"k6", &lens.k6}, {"p1", &lens.p1}, {"p2", &lens.p2}};
}

std::vector<Parameter> named(KannalaBrandt& lens) {
  return {{"k1", &lens.k1}, {"k2", &lens.k2}, {"k3", &lens.k3}, {"k4", &lens.k4}};
}

std::vector<Parameter> named(UnifiedSpherical& lens) {
  std::vector<Parameter> result = named(lens.distortion);
  result.insert(result.begin(), {"xi", &lens.xi, not_negative});
  return result;
}

std::vector<Parameter> named(Eucm& lens) {
  return {{"alpha", &lens.alpha, zero_to_one}, {"beta", &lens.beta, positive}};
}

std::vector<Parameter> named(DoubleSphere& lens) {
  return {{"xi", &lens.xi, above_minus_one_to_one}, {"alpha", &lens.alpha, zero_to_one}};
}

std::vector<Parameter> named(LensModel& lens) {
  return std::visit([](auto& family) { return named(family); }, lens);
}

LensModel defaults(std::string_view family) {
  for (const auto& [name, lens] : families)
    if (name == family) return lens;
  throw std::runtime_error(
      fmt::format("lens: unknown family '{}'; use one of {}", family, fmt::join(family_names(), ", ")));
}

}  // namespace

std::string_view family_name(const LensModel& lens) {
  return families[lens.index()].first;
}

std::vector<std::string_view> family_names() {
  std::vector<std::string_view> names;
  for (const auto& family : families) names.push_back(family.first);
  return names;
}

std::vector<std::pair<std::string_view, double>> parameters(const LensModel& lens) {
  LensModel copy = lens;
  std::vector<std::pair<std::string_view, double>> result;
  for (const Parameter& parameter : named(copy)) result.emplace_back(parameter.name, *parameter.value);
  return result;
}

LensModel lens_from_parameters(std::string_view family, const std::map<std::string, double>& parameters) {
  LensModel lens = defaults(family);
  const std::vector<Parameter> known = named(lens);
  for (const auto& [name, value] : parameters) {
    const auto same = [&](const Parameter& parameter) { return parameter.name == name; };
    const auto found = std::find_if(known.begin(), known.end(), same);
    if (found == known.end()) {
      std::vector<std::string_view> names;
      for (const Parameter& parameter : known) names.push_back(parameter.name);
      throw std::runtime_error(
          fmt::format("{}: unknown parameter '{}'; use {}", family, name, fmt::join(names, ", ")));
    }
    *found->value = value;
  }
  if (const std::string why = fault(lens); !why.empty())
    throw std::runtime_error(fmt::format("{}: {}", family, why));
  return lens;
}

std::string fault(const LensModel& lens) {
  LensModel copy = lens;
  for (const auto& [name, value, range] : named(copy)) {
    if (!std::isfinite(*value)) return fmt::format("{}: must be finite", name);
    if (!range.contains(*value)) return fmt::format("{}: must be {}, is {:.6g}", name, range.text, *value);
  }
  return "";
}

std::string description(const LensModel& lens) {
  std::string text(family_name(lens));
  for (const auto& [name, value] : parameters(lens)) text += fmt::format(", {} {:.6g}", name, value);
  return text;
}

}  // namespace cps
