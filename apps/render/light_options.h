#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <string>

#include "scenes/daylight.h"

namespace cps {

/// Options of sun and sky as the user wrote them.
struct LightRequest {
  std::optional<std::string> sky, sun_irradiance;
  Daylight daylight;
};

/// Adds the options of sun and sky, bound to `request`.
void describe_light(LightRequest& request, boost::program_options::options_description_easy_init add);

/// The daylight that the options describe. Throws boost::program_options::error.
Daylight daylight_of(const LightRequest& request);

}  // namespace cps
