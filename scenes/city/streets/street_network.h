#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scenes/city/geometry/plan_geometry.h"

/// The streets as a planar graph: segments join junctions; the faces of the graph are the blocks.
namespace cps::city {

/// A street's cross-section, seen along its centre line. Traffic keeps to the right.
struct StreetProfile {
  std::string kind;
  int lanes_forward = 1, lanes_backward = 1;
  double lane_width_m = 3.25;
  double parking_left_m = 0, parking_right_m = 0;
  double pavement_m = 3;
  bool centre_line = true;  ///< false in quiet streets
  /// Width of cycle tracks on the carriageway, between the lanes and the parking bays or the kerb.
  double cycle_left_m = 0, cycle_right_m = 0;
  double pavement_cycle_m = 0;  ///< width of cycle tracks on the pavements
  double median_m = 0;          ///< kerbed strip between the directions
  bool tram_tracks = false;     ///< on the innermost lane of each direction

  double half_width() const {
    return (edge_left_m() + edge_right_m() + median_m + (lanes_forward + lanes_backward) * lane_width_m) / 2;
  }
  /// Width between the outermost lane and the kerb.
  double edge_left_m() const { return parking_left_m + cycle_left_m; }
  double edge_right_m() const { return parking_right_m + cycle_right_m; }
  /// Offset of a lane's middle from the centre line (positive: left). Lanes are numbered from their own kerb.
  double forward_lane_offset(int lane) const {
    return -half_width() + edge_right_m() + (lane + 0.5) * lane_width_m;
  }
  double backward_lane_offset(int lane) const {
    return half_width() - edge_left_m() - (lane + 0.5) * lane_width_m;
  }
  /// Offset of the line between the two directions; with a median, of its middle.
  double divider_offset() const {
    return -half_width() + edge_right_m() + lanes_forward * lane_width_m + median_m / 2;
  }
};

struct Street {
  std::string name;
  StreetProfile profile;
  std::vector<int> segments;  ///< in order, all in the street's direction
};

/// A piece of street between two junctions. With `street` −1 it is no road but the border of the built area.
struct Segment {
  int street = -1;
  int from = 0, to = 0;  ///< junctions
  Polyline centre;
  double half_width = 0;
  double cut_from = 0, cut_to = 0;  ///< metres at each end that belong to the junction
};

/// A segment in one of its two directions; a block lies on its left.
struct Side {
  int segment = 0;
  bool reversed = false;
  bool operator==(const Side&) const = default;
};

/// A ring of one or two lanes around an island, by the radii of the outer kerb and of the island's kerb.
/// Curves of radius `fillet_m` join the streets' kerbs to it.
struct Roundabout {
  double outer_m = 15, island_m = 9, fillet_m = 8;
  int lanes = 1;

  /// Radius of the middle of lane number `lane`, counted from the outer kerb.
  double lane_radius_m(int lane) const { return outer_m - (lane + 0.5) * (outer_m - island_m) / lanes; }
};

struct Junction {
  Vec2 position;
  std::vector<Side> arms;     ///< directed away from the junction, anticlockwise
  std::vector<double> radii;  ///< kerb radius between arm i and arm i + 1; 0 at roundabouts
  std::optional<Roundabout> roundabout;
};

/// A face of the graph, by its border, anticlockwise.
struct Block {
  std::vector<Side> sides;
  bool at_rim = false;  ///< part of its border is the border of the built area
};

struct StreetNetwork {
  std::vector<Junction> junctions;
  std::vector<Segment> segments;
  std::vector<Street> streets;
  std::vector<Block> blocks;
  Polygon rim;  ///< the border of the built area

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
  /// The centre line in the side's direction, moved to its left by `left_m`.
  Polyline line(const Side& side, double left_m) const;
  /// The line where the carriageway meets the kerb, moved into the block by `inset_m`.
  Polyline kerb_line(const Side& side, double inset_m = 0) const;
  /// Kerb radius of the corner at the end of `side`.
  double corner_radius(const Side& side) const;
};

/// Two sides of a block that meet at a smaller angle run straight on, without a corner.
inline constexpr double straight_on_rad = 0.2;

/// Sorts the arms of each junction and finds the blocks, which are the bounded faces of the graph.
void find_blocks(StreetNetwork& network);

}  // namespace cps::city
