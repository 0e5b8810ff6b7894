#include "dataset/exchange/other_models.h"

#include <algorithm>
#include <array>
#include <cctype>

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
  constexpr std::array keys{"model",           "cameramodel",    "modeltype",       "type",
                            "distortionmodel", "distortiontype", "lensmodel",       "lenstype",
                            "projection",      "projectiontype", "projectionmodel", "cameratype",
                            "calibrationmodel"};
  return is_one_of(key, keys);
}

/// `fisheye_model`, `use_fisheye`, `omnidir_flags`, …
bool names_a_family(const std::string& key) {
  constexpr std::array families{"fisheye", "omni", "equidistant", "kannala", "spherical", "panoram"};
  return std::any_of(families.begin(), families.end(),
                     [&](const char* family) { return key.find(family) != std::string::npos; });
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

std::string shown(const nlohmann::json& value) {
  if (value.is_structured()) return "given";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

}  // namespace

std::string plain_key(const std::string& key) {
  std::string result;
  for (const char c : key)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

bool names_brown_conrady(const std::string& name) {
  constexpr std::array names{"",
                             "none",
                             "pinhole",
                             "perspective",
                             "frame",
                             "opencv",
                             "fullopencv",
                             "radial",
                             "simpleradial",
                             "simplepinhole",
                             "brown",
                             "brownconrady",
                             "radtan",
                             "radialtangential",
                             "plumbbob",
                             "rationalpolynomial",
                             "rectilinear",
                             "standard"};
  return is_one_of(plain_key(name), names);
}

void refuse_other_models(const JsonKeys& keys, std::initializer_list<const char*> known) {
  if (!keys.json.is_object()) return;
  for (const auto& [key, value] : keys.json.items()) {
    if (std::find(known.begin(), known.end(), key) != known.end()) continue;
    const std::string name = plain_key(last_part(key));
    if (names_a_model(name) && value.is_string() && !names_brown_conrady(value.get<std::string>()))
      keys.fail(key, "is " + shown(value) +
                         ", another lens model than Brown-Conrady: calibrate with k1 k2 p1 p2 k3");
    if (names_a_family(name) && !says_no(value))
      keys.fail(
          key,
          "is " + shown(value) +
              ": the file describes another lens model than Brown-Conrady: calibrate with k1 k2 p1 p2 k3");
    if (is_coefficient(name) && !is_zero(value))
      keys.fail(
          key,
          "is " + shown(value) +
              ", a coefficient that Brown-Conrady (k1 k2 p1 p2 k3) does not have here: calibrate without it");
  }
}

}  // namespace cps
