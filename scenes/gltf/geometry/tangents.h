#pragma once

#include "scenes/scene.h"

namespace cps::gltf {

/// Makes tangents for a normal map that is looked up through `slot`, as MikkTSpace does (Mikkelsen 2008),
/// which glTF 2.0 §3.7.2.1 asks for: vertices equal in position, normal and texture coordinates are one; its
/// tangent is the mean of ∂position/∂u over its triangles, each weighted by its angle there, all seen along
/// the normal; vertices between mirrored and unmirrored uv are split. Unlike MikkTSpace, triangles that meet
/// in a vertex without sharing edges (a bow tie) still count as neighbours.
void make_tangents(Mesh& mesh, const TextureSlot& slot);

/// Brings tangents to length one and a handedness of ±1, which compressed files have but nearly. False when
/// one is too far from it to mean anything.
bool normalize_tangents(Mesh& mesh);

}  // namespace cps::gltf
