#include "dataset/exchange/lens_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <utility>

namespace cps {
namespace {

/// The part behind the last dot: ORB-SLAM writes `Camera1.k4`.
std::string last_part(const std::string& key) {
  const std::size_t dot = key.rfind('.');
  return dot == std::string::npos ? key : key.substr(dot + 1);
}

template <std::size_t n>
bool is_one_of(const std::string& name, const std::array<const char*, n>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool names_a_model(const std::string& key) {
  constexpr std::array words{"model", "type", "projection"};  // alone; a `sensor_type` says nothing
  constexpr std::array endings{"cameramodel", "modeltype",       "distortionmodel", "distortiontype",
                               "lensmodel",   "lenstype",        "projectiontype",  "projectionmodel",
                               "cameratype",  "calibrationmodel"};
  return is_one_of(key, words) || std::any_of(endings.begin(), endings.end(),
                                              [&](const char* ending) { return key.ends_with(ending); });
}

bool is_coefficient(const std::string& key) {
  constexpr std::array names{"xi",   "alpha", "beta", "gamma", "lambda", "epsilon", "tau",  "taux",
                             "tauy", "skew",  "mu",   "mv",    "u0",     "v0",      "shear"};
  if (is_one_of(key, names)) return true;
  return key.size() == 2 && std::string("kpsbjl").find(key[0]) != std::string::npos &&
         std::isdigit(static_cast<unsigned char>(key[1])) != 0;
}

bool is_zero(const nlohmann::json& value) {
  if (value.is_number()) return value.get<double>() == 0;
  if (value.is_array()) return std::all_of(value.begin(), value.end(), is_zero);
  return value.is_null();
}

bool says_no(const nlohmann::json& value) {
  if (value.is_boolean()) return !value.get<bool>();
  if (value.is_string()) {
    const std::string text = plain_key(value.get<std::string>());
    return text.empty() || text == "false" || text == "no" || text == "off" || text == "none";
  }
  return is_zero(value);
}

bool says_yes(const nlohmann::json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_string()) {
    const std::string text = plain_key(value.get<std::string>());
    return text == "true" || text == "yes" || text == "on";
  }
  return value.is_number() && !is_zero(value);
}

std::string shown(const nlohmann::json& value) {
  if (value.is_structured()) return "given";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

[[noreturn]] void refuse_model(const std::string& where, const std::string& name) {
  throw std::runtime_error(where + ": is " + name +
                           ", a lens model that cps does not read here: calibrate with brown_conrady, "
                           "rational, kannala_brandt, unified_spherical, eucm or double_sphere");
}

/// `fisheye_model`, `use_fisheye`, `omnidir_flags`, …: the model that the key is named after, if it is.
std::optional<NamedLens> lens_of_key(const JsonKeys& keys, const std::string& key,
                                     const nlohmann::json& value) {
  const std::string name = plain_key(last_part(key)), where = keys.file + ": " + key;
  constexpr std::pair<const char*, NamedLens> families[] = {{"fisheye", NamedLens::kannala_brandt},
                                                            {"equidistant", NamedLens::kannala_brandt},
                                                            {"kannala", NamedLens::kannala_brandt},
                                                            {"omni", NamedLens::unified_spherical}};
  constexpr std::array others{"spherical", "panoram", "ftheta", "equirect"};
  if (says_no(value)) return {};
  for (const char* family : others)
    if (name.find(family) != std::string::npos) refuse_model(where, shown(value));
  for (const auto& [family, lens] : families) {
    if (name.find(family) == std::string::npos) continue;
    if (says_yes(value)) return lens;
    if (value.is_string() && lens_of_name(value.get<std::string>(), where) == lens) return lens;
    refuse_model(where, shown(value));
  }
  return {};
}

std::optional<NamedLens> lens_of_entry(const JsonKeys& keys, const std::string& key,
                                       const nlohmann::json& value) {
  if (!names_a_model(plain_key(last_part(key))) || !value.is_string()) return lens_of_key(keys, key, value);
  return lens_of_name(value.get<std::string>(), keys.file + ": " + key);
}

}  // namespace

std::string plain_key(const std::string& key) {
  std::string result;
  for (const char c : key)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

std::optional<NamedLens> lens_of_name(const std::string& name, const std::string& where) {
  constexpr std::array projections{"", "none", "pinhole", "perspective", "frame", "rectilinear", "standard"};
  constexpr std::array plane{
      "opencv",       "fullopencv", "radial",           "simpleradial", "simplepinhole",      "brown",
      "brownconrady", "radtan",     "radialtangential", "plumbbob",     "rationalpolynomial", "rational"};
  constexpr std::array fisheye{"fisheye", "opencvfisheye",       "equidistant",    "equidistantfisheye",
                               "equi",    "kannalabrandt",       "kannalabrandt4", "kannalabrandt8",
                               "kb4",     "simpleradialfisheye", "radialfisheye"};
  constexpr std::array sphere{"omni", "omnidir", "omnidirectional", "mei", "unifiedspherical"};
  constexpr std::array double_sphere{"ds", "doublesphere"};
  const std::string plain = plain_key(name);
  if (is_one_of(plain, projections)) return {};
  if (is_one_of(plain, plane)) return NamedLens::plane;
  if (is_one_of(plain, fisheye)) return NamedLens::kannala_brandt;
  if (is_one_of(plain, sphere)) return NamedLens::unified_spherical;
  if (is_one_of(plain, double_sphere)) return NamedLens::double_sphere;
  if (plain == "eucm") return NamedLens::eucm;
  refuse_model(where, name);
}

NamedLens named_lens(const JsonKeys& keys, std::initializer_list<NamedLens> readable) {
  if (!keys.json.is_object()) return NamedLens::plane;
  std::optional<NamedLens> found;
  std::string found_key;
  for (const auto& [key, value] : keys.json.items()) {
    const std::optional<NamedLens> lens = lens_of_entry(keys, key, value);
    if (!lens) continue;
    if (std::find(readable.begin(), readable.end(), *lens) == readable.end())
      refuse_model(keys.file + ": " + key, shown(value));
    // Omnidirectional lenses have a distortion on their plane, which some files name, too.
    const bool adds_nothing = *lens == NamedLens::plane && found == NamedLens::unified_spherical;
    const bool completes = *lens == NamedLens::unified_spherical && found == NamedLens::plane;
    if (found && *found != *lens && !adds_nothing && !completes)
      keys.fail(key, "is " + shown(value) + ", but " + found_key +
                         " names another lens model: keep the right one of the two");
    if (adds_nothing) continue;
    found = lens;
    found_key = key;
  }
  return found.value_or(NamedLens::plane);
}

void refuse_other_coefficients(const JsonKeys& keys, std::initializer_list<const char*> known) {
  if (!keys.json.is_object()) return;
  for (const auto& [key, value] : keys.json.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    if (is_coefficient(plain_key(last_part(key))) && !is_zero(value))
      keys.fail(key,
                "is " + shown(value) +
                    ", a coefficient that the file's lens model does not have here: calibrate without it");
  }
}

}  // namespace cps
