#pragma once

namespace cps {

/// What a GGX surface reflects of a uniform white surrounding, split as f0·scale + f90·bias (Karis 2013,
/// "Real shading in Unreal Engine 4"), with Schlick's Fresnel.
struct SpecularAlbedo {
  float scale, bias;
  float operator()(float f0, float f90 = 1.0f) const { return f0 * scale + f90 * bias; }
};

/// Seen from a direction at `cosine` to the normal; `roughness` is glTF's (α = roughness²). From a table
/// filled once, interpolated: within 0.003.
SpecularAlbedo specular_albedo(float roughness, float cosine);

/// The same averaged over the cosine-weighted hemisphere.
SpecularAlbedo mean_specular_albedo(float roughness);

}  // namespace cps
