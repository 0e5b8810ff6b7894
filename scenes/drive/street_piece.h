#pragma once

#include "scenes/drive/ground_layers.h"

namespace cps {

/// The piece of ground that is most of a street.
struct StreetPiece {
  int piece = -1;  ///< index; −1: there is none
  int rivals = 0;  ///< other pieces with at least a tenth as many things beside them
};

/// Chooses it: large, under the open sky, with things beside it that rise from it. Ground without any, such
/// as a lawn around a town or the sea below it, and roofs, are none.
StreetPiece street_piece(const GroundLayers& layers, const SceneRays& rays);

}  // namespace cps
