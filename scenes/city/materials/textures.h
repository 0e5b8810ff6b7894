#pragma once

#include "random/counter_hash.h"
#include "scenes/city/materials/paint.h"

/// The city's painted surfaces. Each is a square tile of the stated size; looks vary with the stream.
namespace cps::city {

inline constexpr double asphalt_tile_m = 3.0, paving_tile_m = 2.4, kerb_tile_m = 2.0, grass_tile_m = 2.0,
                        paint_tile_m = 2.0;
inline constexpr double brick_tile_m = 2.0, plaster_tile_m = 2.0, concrete_tile_m = 2.0, roof_tile_m = 2.4,
                        flat_roof_tile_m = 3.0;
inline constexpr double bark_tile_m = 1.0, sheet_tile_m = 2.0;
inline constexpr int curtain_wall_panels = 8, curtain_wall_storeys = 4;
inline constexpr double curtain_wall_tile_m = 14.4;

TextureSet asphalt_texture(Stream stream);
TextureSet paving_texture(Stream stream);  ///< slabs or small pavers, by the stream
TextureSet kerb_texture(Stream stream);    ///< stones one metre long, along u
TextureSet grass_texture(Stream stream);
TextureSet road_paint_texture(Stream stream);

TextureSet brick_texture(Stream stream);
TextureSet plaster_texture(Stream stream);  ///< nearly white, to be tinted by the material
TextureSet concrete_texture(Stream stream);
TextureSet roof_tile_texture(Stream stream);  ///< ridge towards the image's top
TextureSet flat_roof_texture(Stream stream);

TextureSet curtain_wall_texture(Stream stream);  ///< panes and spandrels, nearly white where glass is tinted
TextureSet sheet_texture(Stream stream);         ///< ribs 200 mm apart, to be tinted

TextureSet bark_texture(Stream stream);
TextureSet birch_bark_texture(Stream stream);
/// A twig with leaves, stem at the middle of the lower edge; transparent outside (RGBA).
TextureSet leaf_texture(Stream stream);
TextureSet fine_leaf_texture(Stream stream);  ///< many small round leaves, as birches and poplars have
TextureSet needle_texture(Stream stream);

}  // namespace cps::city
