#include "apps/render/lens_choice.h"

#include <algorithm>
#include <stdexcept>

#include "apps/options.h"
#include "apps/render/text_options.h"
#include "dataset/exchange/model_calibration.h"

namespace po = boost::program_options;

namespace cps {
namespace {

bool is_coefficients(const std::string& text) {
  return text.size() > 2 && (text[0] == 'k' || text[0] == 'p') && text[2] == '=';
}

/// "k1=…,p2=…", in any order; missing coefficients are 0.
Distortion parse_coefficients(const std::string& text) {
  Distortion lens;
  const std::pair<const char*, double*> names[] = {
      {"k1=", &lens.k1}, {"k2=", &lens.k2}, {"k3=", &lens.k3}, {"p1=", &lens.p1}, {"p2=", &lens.p2}};
  for (const auto& part : flag_value<std::vector<std::string>>("lens", text)) {
    double* target = nullptr;
    for (const auto& [name, coefficient] : names)
      if (part.starts_with(name)) target = coefficient;
    if (!target)
      throw po::error("--lens " + text + ": '" + part + "' must be k1=, k2=, k3=, p1= or p2= and a number");
    *target = parse_numbers("lens", part.substr(3), 1, "coefficients like k1=-0.2,k2=0.05")[0];
  }
  return lens;
}

bool names_family(const std::string& text) {
  return std::ranges::any_of(family_names(), [&](std::string_view family) {
    return text == family || text.starts_with(std::string(family) + ":");
  });
}

/// "FAMILY:name=value,…"; missing parameters keep the family's defaults.
LensModel parse_model(const std::string& text) {
  const std::string family = text.substr(0, text.find(':'));
  std::map<std::string, double> parameters;
  if (family.size() < text.size())
    for (const auto& part : flag_value<std::vector<std::string>>("lens", text.substr(family.size() + 1))) {
      const std::size_t equals = part.find('=');
      if (equals == std::string::npos)
        throw po::error("--lens " + text + ": '" + part + "' must be a parameter's name, = and a number");
      const double value = parse_numbers("lens", part.substr(equals + 1), 1,
                                         "parameters like kannala_brandt:k1=-0.02,k2=0.001")[0];
      if (!parameters.emplace(part.substr(0, equals), value).second)
        throw po::error("--lens " + text + ": '" + part + "': is there twice");
    }
  try {
    return lens_from_parameters(family, parameters);
  } catch (const std::runtime_error& error) {
    throw po::error("--lens " + text + ": " + error.what());
  }
}

}  // namespace

LensChoice lens_choice(const std::string& text, const std::string& camera_name) {
  if (is_coefficients(text)) return {.lens = parse_coefficients(text)};
  if (names_family(text)) return {.lens = parse_model(text)};
  const ModelCamera camera = read_model_camera(text, camera_name);
  return {.lens = camera.lens, .calibrated = camera.pinhole};
}

}  // namespace cps
