#pragma once

#include <string>
#include <vector>

namespace cps {

/// What kind of place a city is. `mixed`: districts of the other four.
enum class CityStyle { european, downtown, suburb, industrial, mixed };

/// All styles' names, in the order of the enumeration.
const std::vector<std::string>& city_style_names();

std::string to_string(CityStyle style);

/// The style of that name. Throws std::runtime_error: one line that lists the styles.
CityStyle city_style_from(const std::string& name);

}  // namespace cps
