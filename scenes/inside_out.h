#pragma once

#include "scenes/scene.h"

namespace cps {

/// Whether a mesh is a shell turned inside out: front faces inwards, at most a tenth of its edges open, and
/// not wide open like a valley. Sky domes and the outline hulls of cartoon-like models are such shells. With
/// a single-sided material only the far side of such a shell is visible; treated as solid it would block all
/// light to what is inside.
bool is_inside_out(const Mesh& mesh);

}  // namespace cps
