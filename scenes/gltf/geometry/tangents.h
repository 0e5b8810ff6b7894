#pragma once

#include "scenes/scene.h"

namespace cps::gltf {

/// Makes tangents for the normal map in `slot` as MikkTSpace does (Mikkelsen 2008; required by glTF 2.0
/// §3.7.2.1). Vertices equal in position, normal and texture coordinates count as one. Its tangent is the
/// mean of ∂position/∂u over its triangles, projected onto the normal's plane and weighted by the triangle's
/// angle at the vertex. Vertices shared by mirrored and unmirrored uv are split. Unlike MikkTSpace, triangles
/// that meet in a vertex without sharing an edge count as neighbours.
void make_tangents(Mesh& mesh, const TextureSlot& slot);

/// Normalises tangents to length 1 and handedness ±1, from which compressed files differ a little. Returns
/// false if one is off by a factor of 2 or more.
bool normalize_tangents(Mesh& mesh);

}  // namespace cps::gltf
