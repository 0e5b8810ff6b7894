#pragma once

#include <vector>

#include "scenes/drive/ground_grid.h"

namespace cps {

/// Drives over drivable ground: walks that keep away from what stands about, begin where there is a long way
/// ahead, turn by at most 10° a metre, and end after 120 m or where there is no way on. They keep 3 m from
/// one another, so that each may belong to another part of a split. The same ground gives the same drives;
/// none where no walk of 4 m fits.
std::vector<Lane> find_drives(const GroundGrid& ground);

}  // namespace cps
