#include "sampler/lenses/model_prior.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "numbers/interval.h"

namespace cps {
namespace {

struct ParameterPrior {
  const char* name;
  Interval range;
};

struct FamilyPrior {
  std::string_view family;
  std::vector<ParameterPrior> parameters;
};

const std::vector<FamilyPrior>& priors() {
  // kannala_brandt: k1 is −1/24 for the equisolid projection, 0 for the equidistant, 1/12 for the
  // stereographic. unified_spherical: ξ is 0 for a pinhole, 1 for the stereographic projection.
  static const std::vector<FamilyPrior> all{
      {"unified_spherical", {{"xi", {0, 1.2}}}},
      {"kannala_brandt",
       {{"k1", {-0.05, 0.09}}, {"k2", {-0.006, 0.006}}, {"k3", {-0.001, 0.001}}, {"k4", {-1e-4, 1e-4}}}},
      {"eucm", {{"alpha", {0.45, 0.75}}, {"beta", {0.8, 1.3}}}},
      {"double_sphere", {{"xi", {-0.3, 0.2}}, {"alpha", {0.5, 0.7}}}}};
  return all;
}

}  // namespace

const std::vector<std::string_view>& prior_families() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const FamilyPrior& prior : priors()) all.push_back(prior.family);
    return all;
  }();
  return names;
}

LensModel draw_model_lens(std::string_view family, Stream stream) {
  const auto prior = std::ranges::find(priors(), family, &FamilyPrior::family);
  if (prior == priors().end()) {
    std::string known;
    for (const std::string_view name : prior_families())
      known += (known.empty() ? "" : ", ") + std::string(name);
    throw std::runtime_error("lens_model " + std::string(family) + ": must be one of " + known);
  }
  std::map<std::string, double> drawn;
  for (std::size_t i = 0; i < prior->parameters.size(); ++i) {
    const auto& [name, range] = prior->parameters[i];
    drawn[name] = random_uniform(stream, i, range.low, range.high);
  }
  return lens_from_parameters(family, drawn);
}

}  // namespace cps
