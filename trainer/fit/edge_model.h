#pragma once

#include <array>
#include <optional>

#include "distortion/brown_conrady.h"
#include "distortion/image_size.h"
#include "trainer/fit/fit_parameters.h"
#include "trainer/images/orientation/orientation.h"

/// Which way the straight edges of an upright world run in a picture: vertical ones, and horizontal ones
/// across the street (Coughlan, Yuille 1999: a Manhattan world). Lengths are half diagonals of the picture,
/// X to the right and Y down from its middle.
namespace cps {

/// A camera in a street as edge_tilts() needs it, with the slopes of its numbers by the parameters.
struct StreetCamera {
  Distortion lens;                ///< apparent coefficients
  double cx = 0, cy = 0;          ///< principal point
  double half_diagonal = 1;       ///< of the frame on the plane z = 1
  FitVector half_diagonal_slope;  ///< ∂half_diagonal/∂parameter
  /// Directions of the two families of edges, unit vectors in the camera's frame, and their slopes by pitch,
  /// roll and yaw.
  struct Direction {
    Eigen::Vector3d along;
    std::array<Eigen::Vector3d, 3> slopes;
  };
  std::array<Direction, edge_families> directions;  ///< up; across the street
  double cx_unit = 1, cy_unit = 1;                  ///< ∂cx/∂output 6, ∂cy/∂output 7
};

/// The camera that the parameters describe, for a picture of this shape. Its H-FOV must lie inside (0, π).
StreetCamera street_camera(const FitVector& parameters, const ImageSize& picture);

/// A tilt, as orientation.h defines it, with its slopes by the parameters.
struct EdgeTilt {
  double tilt = 0;
  FitVector slope;
};

/// Tilts of both families at (X, Y). Each is exact for the camera (its slopes to 1e-7); a family is empty
/// where its tilt is beyond ±.4, farther than tilts are measured, or near its vanishing point. Both are empty
/// where the lens is nearly folded or the point has no ideal one.
std::array<std::optional<EdgeTilt>, edge_families> edge_tilts(const StreetCamera& camera, double x, double y);

}  // namespace cps
