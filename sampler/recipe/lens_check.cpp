#include "sampler/recipe/lens_check.h"

#include <fmt/format.h>

#include "numbers/angles.h"

namespace cps {

void require_lenses(const Recipe& recipe) {
  const CropOrder order = recipe.crop_order();
  const std::vector<double>& hfovs_deg =
      order == CropOrder::base_first ? recipe.base_hfov_deg : recipe.hfov_deg;
  for (std::size_t s = 0; s < recipe.sizes.size(); ++s) {
    if (recipe.lenses[s] == 0) continue;
    const ImageSize& size = recipe.sizes[s];
    for (double hfov_deg : hfovs_deg) try {
        draw_lens(pinhole_from_hfov(size.width, size.height, radians(hfov_deg)), order, recipe.lens_options,
                  make_stream(recipe.seed, "lens check"));
      } catch (const std::runtime_error& error) {
        throw std::runtime_error(
            fmt::format("recipe: {}x{}, {} degrees: {}", size.width, size.height, hfov_deg, error.what()));
      }
  }
}

}  // namespace cps
