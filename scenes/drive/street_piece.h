#pragma once

#include "scenes/drive/ground_layers.h"

namespace cps {

/// The piece that is most of a street: large, under the open sky, with things beside it that rise from it.
/// Ground without any, such as a lawn around a town or the sea below it, and roofs, are none; −1 if there is
/// no other.
int street_piece(const GroundLayers& layers, const SceneRays& rays);

}  // namespace cps
