#pragma once

#include "scenes/scene.h"

namespace cps::gltf {

/// Makes tangents for a normal map that is looked up through `slot`: per vertex the corner-angle-weighted
/// mean of ∂position/∂u over its triangles; vertices between mirrored and unmirrored uv are split. This is
/// MikkTSpace's weighting (Mikkelsen 2008) on the vertices as indexed; MikkTSpace also welds equal vertices,
/// which this does not.
void make_tangents(Mesh& mesh, const TextureSlot& slot);

/// Brings tangents to length one and a handedness of ±1, which compressed files have but nearly. False when
/// one is too far from it to mean anything.
bool normalize_tangents(Mesh& mesh);

}  // namespace cps::gltf
