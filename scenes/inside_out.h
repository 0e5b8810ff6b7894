#pragma once

#include "scenes/scene.h"

namespace cps {

/// Whether a mesh is a shell turned inside out: nearly closed (at most a tenth of its edges are open, and it
/// does not gape like a valley) with its fronts facing inwards, like the outline hulls of drawn-looking
/// models and sky domes. Under a single-sided material such a shell shows its far side only; taken for a
/// solid it would keep all light from what is inside.
bool is_inside_out(const Mesh& mesh);

}  // namespace cps
