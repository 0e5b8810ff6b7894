#pragma once

#include "scenes/city/blocks/district.h"
#include "scenes/city/buildings/building.h"
#include "scenes/city/streets/junctions.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

enum class BlockKind { closed, detached, slabs, park, towers, halls };

/// Kinds of enclosure of a garden or a yard.
enum class BoundaryKind { hedge, picket_fence, mesh_fence, low_wall, high_wall };

struct Boundary {
  BoundaryKind kind = BoundaryKind::hedge;
  Polyline line;
};

enum class GroundKind { grass, paving, asphalt, concrete };

/// A piece of ground with a surface of its own: a driveway, a path, a yard.
struct Pad {
  GroundKind kind = GroundKind::paving;
  Polygon outline;
};

/// Height of pads above the ground around them.
inline constexpr double pad_rise_m = 0.012;

/// A place for a thing on the block's ground, and the direction it faces.
struct Spot {
  Vec2 position, direction;
  double rise_m = 0;  ///< height of the pad below it
};

/// The contents of a block; no two things overlap.
struct BlockPlan {
  BlockKind kind = BlockKind::closed;
  GroundKind ground = GroundKind::grass;
  std::vector<double> pavement_m;  ///< width per side
  Outline border;                  ///< the inner edge of the pavements
  std::vector<BuildingPlan> buildings;
  std::vector<Vec2> trees;  ///< in gardens, courts and parks
  std::vector<Boundary> boundaries;
  std::vector<Pad> pads;          ///< without overlaps
  std::vector<Spot> car_spots;    ///< on driveways and in yards
  std::vector<Spot> goods_spots;  ///< for containers and the like, in yards
};

BlockPlan plan_block(const StreetNetwork& network, int block, const CityCharacter& character,
                     std::uint64_t seed);

/// The mean of a block's corners, which decides its district.
Vec2 block_middle(const StreetNetwork& network, int block);

}  // namespace cps::city
