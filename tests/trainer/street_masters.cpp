#include "tests/trainer/street_masters.h"

#include <OpenImageIO/imagebufalgo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dataset/pixels/master_file.h"
#include "distortion/warp/master_camera.h"
#include "files/files.h"
#include "numbers/angles.h"
#include "sampler/recipe/recipe_keys.h"
#include "sampler/recipe/recipe_values.h"
#include "tests/trainer/street.h"

namespace cps {

void keep_street_masters(const std::filesystem::path& root, const ImageSize& size, int count) {
  Recipe recipe;
  recipe.city_seeds = {1};
  recipe.sizes = {size};
  recipe.hfov_deg = {40, 100};
  recipe.views = count;
  recipe.lenses = 3;
  recipe.lens_options.scheme = LensScheme::shape_prior;
  recipe.sensor = {0, 0, 1e6, 1e6, 0, 0};  // no noise to speak of
  recipe.keep_masters = true;
  nlohmann::ordered_json keys;
  for_each_recipe_key(
      recipe, [&](const char* key, const auto& value, const char*) { keys[key] = value_text(value); });
  write_json(root / "dataset.json", {{"recipe", keys}});

  std::string csv =
      "file,part,width,height,fx,fy,cx,cy,image_width,image_height,base_hfov_deg,set_hfov_deg,exposure,"
      "sha256\n";
  for (int i = 0; i < count; ++i) {
    const double hfov_deg = 40 + 60.0 * i / std::max(1, count - 1);
    // Room for lenses that reach further than the image.
    const double base_deg = degrees(2 * std::atan(1.5 * std::tan(radians(hfov_deg) / 2)));
    const Pinhole base = pinhole_from_hfov(size.width, size.height, radians(base_deg)),
                  camera = master_camera(base, {.oversampling = 3.2}, .15);
    const GrayImage street = render_street({"", camera, {}}, i);
    OIIO::ImageBuf encoded(OIIO::ImageSpec(camera.width, camera.height, 1, OIIO::TypeDesc::FLOAT));
    encoded.set_pixels(encoded.roi(), OIIO::TypeDesc::UINT8, street.pixels.data());
    const OIIO::ImageBuf linear = OIIO::ImageBufAlgo::colorconvert(encoded, "sRGB", "linear");
    const int grey[] = {0, 0, 0};
    const OIIO::ImageBuf picture = OIIO::ImageBufAlgo::channels(linear, 3, grey);
    const std::string bytes = encode_master({picture, OIIO::ImageBufAlgo::sub(picture, picture)});
    const std::string name = "masters/set/front_" + std::to_string(i) + ".exr";
    write_file(root / name, bytes);
    csv += fmt::format("{},train,{},{},{},{},{},{},{},{},{},{},1,{}\n", name, camera.width, camera.height,
                       camera.fx, camera.fy, camera.cx, camera.cy, size.width, size.height, base_deg,
                       hfov_deg, sha256(bytes));
  }
  write_file(root / "masters.csv", csv);
}

}  // namespace cps
