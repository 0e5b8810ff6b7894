#pragma once

#include <string>
#include <vector>

namespace cps {

/// The character of a city. `mixed`: districts of the other four styles.
enum class CityStyle { european, downtown, suburb, industrial, mixed };

/// The styles' names, in the order of the enumeration.
const std::vector<std::string>& city_style_names();

std::string to_string(CityStyle style);

/// The style with that name. Throws std::runtime_error with one line that lists the styles.
CityStyle city_style_from(const std::string& name);

}  // namespace cps
