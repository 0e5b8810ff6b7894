#pragma once

#include "scenes/city/blocks/block_site.h"

/// Functions that fill a block, one per kind, with random numbers from the site's draws.
namespace cps::city {

/// Adjoining houses along all streets around a court, L-shaped at the corners.
void fill_closed_block(BlockSite& site);

/// Detached houses with front gardens, hedges and fences, driveways and garages.
void fill_detached_block(BlockSite& site);

/// Slabs: long blocks of flats on grass.
void fill_slab_block(BlockSite& site);

/// Towers on podiums around paved squares.
void fill_tower_block(BlockSite& site);

/// Industrial halls in walled or fenced yards.
void fill_hall_block(BlockSite& site);

}  // namespace cps::city
