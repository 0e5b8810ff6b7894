#pragma once

#include "scenes/city/city_style.h"

inline constexpr cps::CityStyle all_styles[] = {cps::CityStyle::european, cps::CityStyle::downtown,
                                                cps::CityStyle::suburb, cps::CityStyle::industrial,
                                                cps::CityStyle::mixed};
