#pragma once

namespace cps {

/// Fraction of light that a GGX surface reflects under uniform white light, as f0·scale + f90·bias (Karis
/// 2013, "Real shading in Unreal Engine 4"), with Schlick's Fresnel term.
struct SpecularAlbedo {
  float scale, bias;
  float operator()(float f0, float f90 = 1.0f) const { return f0 * scale + f90 * bias; }
};

/// Towards a viewer at `cosine` to the normal; `roughness` is glTF's (α = roughness²). Interpolated in a
/// table that is computed once: exact to 0.003.
SpecularAlbedo specular_albedo(float roughness, float cosine);

/// The same averaged over the cosine-weighted hemisphere.
SpecularAlbedo mean_specular_albedo(float roughness);

}  // namespace cps
