#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenes/city/city_options.h"
#include "scenes/city/geometry/plan_geometry.h"

/// The streets as a planar graph: junctions joined by segments; the faces between them are the blocks.
namespace cps::city {

/// A street's cross-section, seen in the direction of its centre line; traffic keeps to the right.
struct StreetProfile {
  std::string kind;
  int lanes_forward = 1, lanes_backward = 1;
  double lane_width_m = 3.25;
  double parking_left_m = 0, parking_right_m = 0;
  double pavement_m = 3;
  bool centre_line = true;  ///< quiet streets have none
  /// Cycle tracks on the carriageway, between the parking bays (or the kerb) and the lanes.
  double cycle_left_m = 0, cycle_right_m = 0;
  double pavement_cycle_m = 0;  ///< width of cycle tracks on the pavements
  double median_m = 0;          ///< a kerbed strip between the directions
  bool tram_tracks = false;     ///< in the innermost lane of each direction

  double half_width() const {
    return (edge_left_m() + edge_right_m() + median_m + (lanes_forward + lanes_backward) * lane_width_m) / 2;
  }
  /// What lies between the lanes and the kerb on either side.
  double edge_left_m() const { return parking_left_m + cycle_left_m; }
  double edge_right_m() const { return parking_right_m + cycle_right_m; }
  /// Offset from the centre line (positive: left) of the middle of a lane, counted from its own kerb.
  double forward_lane_offset(int lane) const {
    return -half_width() + edge_right_m() + (lane + 0.5) * lane_width_m;
  }
  double backward_lane_offset(int lane) const {
    return half_width() - edge_left_m() - (lane + 0.5) * lane_width_m;
  }
  /// Offset of the line between the two directions, the middle of the median where there is one.
  double divider_offset() const {
    return -half_width() + edge_right_m() + lanes_forward * lane_width_m + median_m / 2;
  }
};

struct Street {
  std::string name;
  StreetProfile profile;
  std::vector<int> segments;  ///< from end to end, all in the street's direction
};

/// A piece of street between two junctions; `street` −1: no road, only the border of the built area.
struct Segment {
  int street = -1;
  int from = 0, to = 0;  ///< junctions
  Polyline centre;
  double half_width = 0;
  double cut_from = 0, cut_to = 0;  ///< metres at either end that belong to the junction
};

/// A segment seen in one of its directions; the block lies on its left.
struct Side {
  int segment = 0;
  bool reversed = false;
  bool operator==(const Side&) const = default;
};

/// A ring of one or two lanes around an island, by the radii of its outer kerb and of the island's; the
/// streets' kerbs run into it in curves of `fillet_m`.
struct Roundabout {
  double outer_m = 15, island_m = 9, fillet_m = 8;
  int lanes = 1;

  /// Radius of the middle of a lane, counted from the outer kerb.
  double lane_radius_m(int lane) const { return outer_m - (lane + 0.5) * (outer_m - island_m) / lanes; }
};

struct Junction {
  Vec2 position;
  std::vector<Side> arms;     ///< leaving the junction, anticlockwise
  std::vector<double> radii;  ///< kerb radius between arm i and arm i + 1; 0 at roundabouts
  std::optional<Roundabout> roundabout;
};

/// A face of the graph: its border, anticlockwise.
struct Block {
  std::vector<Side> sides;
  bool at_rim = false;  ///< part of its border is the end of the built area
};

struct StreetNetwork {
  std::vector<Junction> junctions;
  std::vector<Segment> segments;
  std::vector<Street> streets;
  std::vector<Block> blocks;
  Polygon rim;  ///< the border of everything built

  int start(const Side& side) const {
    return side.reversed ? segments[side.segment].to : segments[side.segment].from;
  }
  int end(const Side& side) const {
    return side.reversed ? segments[side.segment].from : segments[side.segment].to;
  }
  bool is_road(const Side& side) const { return segments[side.segment].street >= 0; }
  const StreetProfile& profile(const Side& side) const {
    return streets[segments[side.segment].street].profile;
  }
  /// The centre line in the side's direction, moved `left_m` to its left.
  Polyline line(const Side& side, double left_m) const;
  /// The line where carriageway and kerb meet, moved `inset_m` into the block.
  Polyline kerb_line(const Side& side, double inset_m = 0) const;
  /// Kerb radius of the corner that `side` leads to.
  double corner_radius(const Side& side) const;
};

/// Below this turn two sides of a block run straight on and meet without a corner.
inline constexpr double straight_on_rad = 0.2;

/// Draws streets, junctions and blocks for a built area of `options.extent_m`.
StreetNetwork draw_street_network(const CityOptions& options);

/// Sorts the arms of each junction and finds the blocks; the unbounded face is left out.
void find_blocks(StreetNetwork& network);

/// Draws roundabouts and kerb radii and finds where each segment's own carriageway begins.
void shape_junctions(StreetNetwork& network, const CityOptions& options);

/// The junction's asphalt: from arm to arm around the rounded kerbs, anticlockwise. Empty where no road meets
/// another.
Polygon junction_border(const StreetNetwork& network, int junction);

/// The block's outline, `inset_m` metres behind the kerb (per side), its corners rounded by the kerb radius
/// less `corner_shrink_m` (at a roundabout the ring's kerb, moved back by that much). Outlines of one block
/// have the same number of points, so that two of them bound a strip.
struct Outline {
  Polygon points;
  std::vector<int> side;     ///< which of the block's sides the stretch from this point on belongs to
  std::vector<bool> corner;  ///< that stretch is part of a rounded corner
};
Outline outline(const StreetNetwork& network, const Block& block, const std::vector<double>& inset_m,
                double corner_shrink_m);

}  // namespace cps::city
