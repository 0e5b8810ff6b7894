#pragma once

#include "scenes/city/blocks/district.h"
#include "scenes/city/buildings/building.h"
#include "scenes/city/streets/street_network.h"

namespace cps::city {

enum class BlockKind { closed, detached, slabs, park, towers, halls };

/// What encloses a garden or a yard.
enum class BoundaryKind { hedge, picket_fence, mesh_fence, low_wall, high_wall };

struct Boundary {
  BoundaryKind kind = BoundaryKind::hedge;
  Polyline line;
};

enum class GroundKind { grass, paving, asphalt, concrete };

/// A piece of ground of its own: a driveway, a path, a yard.
struct Pad {
  GroundKind kind = GroundKind::paving;
  Polygon outline;
};

/// Pads lie this much above the ground around them.
inline constexpr double pad_rise_m = 0.012;

/// Where something stands on the block's own ground, and where it looks.
struct Spot {
  Vec2 position, direction;
  double rise_m = 0;  ///< of a pad below it
};

/// What one block is filled with; nothing of it overlaps anything else.
struct BlockPlan {
  BlockKind kind = BlockKind::closed;
  GroundKind ground = GroundKind::grass;
  std::vector<double> pavement_m;  ///< per side
  Outline border;                  ///< where the pavements end
  std::vector<BuildingPlan> buildings;
  std::vector<Vec2> trees;  ///< in gardens, courts and parks
  std::vector<Boundary> boundaries;
  std::vector<Pad> pads;          ///< none overlaps another
  std::vector<Spot> car_spots;    ///< on driveways and in yards
  std::vector<Spot> goods_spots;  ///< containers and the like, in yards
};

BlockPlan plan_block(const StreetNetwork& network, int block, const CityCharacter& character,
                     std::uint64_t seed);

/// The middle of a block's corners: decides which district it belongs to.
Vec2 block_middle(const StreetNetwork& network, int block);

}  // namespace cps::city
