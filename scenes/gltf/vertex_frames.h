#pragma once

#include "scenes/scene.h"

namespace cps::gltf {

/// Gives every triangle its own vertices and its geometric normal, and drops the tangents: what glTF 2.0
/// §3.7.2.1 asks for where normals are missing.
void make_flat_normals(Mesh& mesh);

/// Normalises the normals; those that are not finite or have no length become the area-weighted mean of their
/// triangles' normals. Returns how many had to be replaced.
std::size_t repair_normals(Mesh& mesh);

/// Makes tangents for a normal map that is looked up through `slot`: per vertex the corner-angle-weighted
/// mean of ∂position/∂u over its triangles; vertices between mirrored and unmirrored uv are split. This is
/// MikkTSpace's weighting (Mikkelsen 2008) on the vertices as indexed; MikkTSpace also welds equal vertices,
/// which this does not.
void make_tangents(Mesh& mesh, const TextureSlot& slot);

/// Brings tangents to length one and a handedness of ±1, which compressed files have but nearly. False when
/// one is too far from it to mean anything.
bool normalize_tangents(Mesh& mesh);

}  // namespace cps::gltf
