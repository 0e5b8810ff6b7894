#include "sampler/recipe/lens_check.h"

#include <fmt/format.h>

#include "numbers/angles.h"
#include "sampler/lenses/family_draw.h"

namespace cps {

namespace {

/// Draws a lens as a plan does, but from a stream of its own. Throws as drawing does.
void try_draw(const Recipe& recipe, const ImageSize& size, double hfov_deg) {
  const Stream stream = make_stream(recipe.seed, "lens check");
  if (recipe.is_brown_conrady())
    draw_lens(pinhole_from_hfov(size.width, size.height, radians(hfov_deg)), recipe.crop_order(),
              recipe.lens_options, stream);
  else
    draw_family_camera(recipe.lens_model, size, radians(hfov_deg), stream);
}

}  // namespace

void require_lenses(const Recipe& recipe) {
  const std::vector<double>& hfovs_deg =
      recipe.crop_order() == CropOrder::base_first ? recipe.base_hfov_deg : recipe.hfov_deg;
  for (std::size_t s = 0; s < recipe.sizes.size(); ++s) {
    if (recipe.lenses[s] == 0) continue;
    const ImageSize& size = recipe.sizes[s];
    for (double hfov_deg : hfovs_deg) try {
        try_draw(recipe, size, hfov_deg);
      } catch (const std::runtime_error& error) {
        throw std::runtime_error(
            fmt::format("recipe: {}x{}, {} degrees: {}", size.width, size.height, hfov_deg, error.what()));
      }
  }
}

}  // namespace cps
