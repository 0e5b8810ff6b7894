#pragma once

#include <vector>

#include "scenes/drive/ground_grid.h"

namespace cps {

/// Finds drives over drivable ground, as lanes of streets of their own. A drive begins where there is a long
/// way ahead with things around, keeps away from obstacles and from places without any, turns by at most 10°
/// per metre, and ends after 120 m or where it cannot go on. Drives keep 3 m apart, so that each may belong
/// to another split. The same ground gives the same drives; the result is empty if none of 4 m fits.
std::vector<Lane> find_drives(const GroundGrid& ground);

}  // namespace cps
