#include "scenes/city/city_style.h"

#include <algorithm>
#include <stdexcept>

namespace cps {

const std::vector<std::string>& city_style_names() {
  static const std::vector<std::string> names{"european", "downtown", "suburb", "industrial", "mixed"};
  return names;
}

std::string to_string(CityStyle style) {
  return city_style_names()[static_cast<std::size_t>(style)];
}

CityStyle city_style_from(const std::string& name) {
  const std::vector<std::string>& names = city_style_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<CityStyle>(found - names.begin());
  std::string list;
  for (const std::string& known : names) list += (list.empty() ? "" : ", ") + known;
  throw std::runtime_error("is none of " + list);
}

}  // namespace cps
