#pragma once

#include <boost/program_options.hpp>
#include <optional>
#include <string>

#include "scenes/daylight.h"

namespace cps {

/// Sun and sky as written.
struct LightRequest {
  std::optional<std::string> sky, sun_irradiance;
  Daylight daylight;
};

/// The options of sun and sky, bound to `request`.
void describe_light(LightRequest& request, boost::program_options::options_description_easy_init add);

/// What they mean. Throws boost::program_options::error.
Daylight daylight_of(const LightRequest& request);

}  // namespace cps
