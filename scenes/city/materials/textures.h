#pragma once

#include "random/counter_hash.h"
#include "scenes/city/materials/paint.h"

/// The city's textures. Each is a square tile with the side length below; its appearance depends on the
/// stream.
namespace cps::city {

inline constexpr double asphalt_tile_m = 3.0, paving_tile_m = 2.4, kerb_tile_m = 2.0, grass_tile_m = 2.0,
                        paint_tile_m = 2.0;
inline constexpr double brick_tile_m = 2.0, plaster_tile_m = 2.0, concrete_tile_m = 2.0, roof_tile_m = 2.4,
                        flat_roof_tile_m = 3.0;
inline constexpr double bark_tile_m = 1.0, sheet_tile_m = 2.0;
inline constexpr int curtain_wall_panels = 8, curtain_wall_storeys = 4;
inline constexpr double curtain_wall_tile_m = 14.4;

TextureSet asphalt_texture(Stream stream);
TextureSet paving_texture(Stream stream);  ///< slabs or small pavers
TextureSet kerb_texture(Stream stream);    ///< stones 1 m long, along u
TextureSet grass_texture(Stream stream);
TextureSet road_paint_texture(Stream stream);

TextureSet brick_texture(Stream stream);
TextureSet plaster_texture(Stream stream);  ///< nearly white; materials tint it
TextureSet concrete_texture(Stream stream);
TextureSet roof_tile_texture(Stream stream);  ///< ridge at the image's top
TextureSet flat_roof_texture(Stream stream);

TextureSet curtain_wall_texture(Stream stream);  ///< panes and spandrels; materials tint them
TextureSet sheet_texture(Stream stream);         ///< ribs 200 mm apart; materials tint it

TextureSet bark_texture(Stream stream);
TextureSet birch_bark_texture(Stream stream);
/// A twig with leaves on a transparent ground (RGBA), its stem at the middle of the lower edge.
TextureSet leaf_texture(Stream stream);
TextureSet fine_leaf_texture(Stream stream);  ///< many small round leaves, as of birches and poplars
TextureSet needle_texture(Stream stream);

}  // namespace cps::city
