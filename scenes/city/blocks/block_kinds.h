#pragma once

#include "scenes/city/blocks/block_site.h"

/// The ways to fill a block; each draws what it needs from the site's draws.
namespace cps::city {

/// Houses wall to wall along all streets, L-shaped at the corners, around a court.
void fill_closed_block(BlockSite& site);

/// Houses on lots of their own: front gardens, hedges and fences, driveways, garages.
void fill_detached_block(BlockSite& site);

/// Long blocks of flats on grass.
void fill_slab_block(BlockSite& site);

/// Towers on podiums around paved squares.
void fill_tower_block(BlockSite& site);

/// Halls in walled or fenced yards.
void fill_hall_block(BlockSite& site);

}  // namespace cps::city
