#pragma once

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "sampler/recipe/lens_keys.h"
#include "sampler/recipe/light_keys.h"
#include "sampler/recipe/recipe.h"
#include "sampler/recipe/recipe_values.h"

namespace cps {

/// The one list of recipe keys: calls visit(key, member, help) for each. Reading, writing and help all come
/// from it, so a key is added here and nowhere else. RecipeT is Recipe or const Recipe.
template <typename RecipeT, typename Visitor>
void for_each_recipe_key(RecipeT& r, Visitor&& visit) {
  visit("name", r.name, "name of the dataset");
  visit("seed", r.seed, "seed of every random choice, a whole number from 0");

  visit("scene", r.scenes,
        "glTF files, separated by commas; a scene without lanes is searched for ground to drive on. --scene, "
        "--city_seed and --cities on the command line replace all scenes of the recipe file");
  visit("city_seed", r.city_seeds, "seeds of procedural cities, separated by commas");
  visit("cities", r.cities, "number of further procedural cities, with drawn seeds, 0 to 100000");
  visit("city_style", r.city_styles,
        "styles of the procedural cities, used in turn: european, downtown, suburb, industrial, mixed; "
        "separated by commas");
  visit("traffic_min", r.traffic_min,
        "least traffic to draw for a city, as a multiple of its style's traffic: 0 (none) to 2");
  visit("traffic_max", r.traffic_max,
        "most traffic to draw for a city, as a multiple of its style's traffic: traffic_min to 2");

  visit("conditions_per_scene", r.conditions_per_scene,
        "conditions per scene, each with a date, an hour, a weather and, in a city, traffic of its own; 1 to "
        "100000");
  for_each_light_key(r.light, visit);

  visit("size", r.sizes, "image sizes, WIDTHxHEIGHT in pixels, separated by commas; 32 to 8192 a side");
  visit("base_hfov_deg", r.base_hfov_deg,
        "horizontal fields of view before the crop, degrees, separated by commas; 5 to 165. The images' "
        "follow from lens and crop");
  visit(
      "hfov_deg", r.hfov_deg,
      "horizontal fields of view of the images, after the crop, degrees, separated by commas; 5 to 165. "
      "Each lens gets the base that leads there. Name either this or base_hfov_deg. With another lens_model: "
      "the angles that the images show along their middle row, 5 to 195");
  visit("views", r.views,
        "places per size and H-FOV, each seen by every camera of the rig; one number, or one per size; 3 to "
        "1000000");

  visit("rig", r.rig,
        "rig file that lists the car's cameras: a path, or a file beside the recipe. Without it: one camera, "
        "1.65 m above the road, that looks straight ahead");
  visit("ego_bonnet", r.ego_bonnet,
        "true: show the bonnet of the camera's own car; its outline tells a network the H-FOV");
  visit("mount_error_deg", r.mount_error_deg,
        "standard deviation of each camera's errors in yaw, pitch and roll, degrees, 0 to 30");
  visit("mount_error_m", r.mount_error_m,
        "standard deviation of each camera's position error along each axis, metres, 0 to 0.5");
  visit("camera_pitch_min_deg", r.camera_pitch_min_deg,
        "least further pitch of each camera, drawn for each place, degrees upwards, -45 to 45");
  visit("camera_pitch_max_deg", r.camera_pitch_max_deg,
        "most further pitch of each camera, degrees upwards, camera_pitch_min_deg to 45");
  visit("camera_roll_min_deg", r.camera_roll_min_deg,
        "least further roll of each camera, drawn for each place, degrees clockwise, -45 to 45");
  visit("camera_roll_max_deg", r.camera_roll_max_deg,
        "most further roll of each camera, degrees clockwise, camera_roll_min_deg to 45");
  visit("lateral_m", r.lateral_m,
        "standard deviation of the car's offset from the lane's centre line, metres, 0 to 2");
  visit("heading_deg", r.heading_deg,
        "standard deviation of the car's heading from the lane's direction, degrees, 0 to 45");
  visit("lane_change_share", r.lane_change_share,
        "share of the places where the car is changing lanes, if the street has another lane in its "
        "direction; 0 to 1");
  visit("clearance_m", r.clearance_m, "free distance required in front of a camera, metres, 0 to 50");
  visit("side_clearance_m", r.side_clearance_m,
        "free distance required in front of a camera that looks more than 60 degrees away from the driving "
        "direction, metres, 0 to 50");

  visit("lenses", r.lenses,
        "distorted images per view, each through a lens of its own; one number, or one "
        "per size; 0 to 10000");
  visit("undistorted", r.undistorted,
        "true: one more image per view, without distortion; false with another lens_model");
  visit("views_per_lens", r.views_per_lens,
        "number of views that share their lenses, counted within train, val and test; 0: all of them");
  visit(
      "lens_model", r.lens_model,
      "family of the lenses: brown_conrady, unified_spherical, kannala_brandt, eucm or double_sphere. Those "
      "of the others are drawn from a prior of their own; each image is traced through its lens, and the "
      "result is not a CPS dataset");
  for_each_lens_key(r.lens_options, visit);

  visit("train_share", r.train_share, "share of the views in the train split, 0.01 to 0.98");
  visit("val_share", r.val_share,
        "share of the views in the val split, 0.01 to 0.98; the rest, at least 0.01, is the test split");
  visit("split", r.split,
        "how views are split: route, every street belongs to one of train, val and test; thesis, at random, "
        "so that the three share streets");

  visit("samples", r.samples,
        "paths per master pixel, even, 2 to 65536; an output pixel is as noisy as the mean of four times as "
        "many");
  visit("max_shaded_vertices", r.max_shaded_vertices,
        "surfaces along a path at which light is gathered, 1 to 64");
  visit(
      "light_method", r.light_method,
      "traced: paths follow all light; cached: light of the sky and between surfaces is kept in cells of the "
      "scene, which has less noise at a fraction of the cost");
  visit("exposure_bias_min_ev", r.sensor.exposure_bias_min_ev,
        "darkest exposure to draw, stops against the metered one, -10 to 10");
  visit("exposure_bias_max_ev", r.sensor.exposure_bias_max_ev,
        "brightest exposure to draw, stops against the metered one, exposure_bias_min_ev to 10");
  visit("full_well_min_e", r.sensor.full_well_min_e,
        "smallest full well to draw, electrons of a white pixel, 1 to 1e7; fewer electrons, more shot noise");
  visit("full_well_max_e", r.sensor.full_well_max_e,
        "largest full well to draw, electrons of a white pixel, full_well_min_e to 1e7");
  visit("read_noise_min_e", r.sensor.read_noise_min_e,
        "smallest read noise to draw, rms electrons, 0 to 1e4");
  visit("read_noise_max_e", r.sensor.read_noise_max_e,
        "largest read noise to draw, rms electrons, read_noise_min_e to 1e4");
  visit(
      "sensor_binning", r.sensor.binning,
      "sensor pixels along each side of an image pixel, 1 to 16; their signals are averaged, as in a reduced "
      "picture, which divides the noise by as much. Full well and read noise are those of a sensor pixel");
  visit("contrast_min", r.sensor.contrast_min,
        "smallest contrast to draw, exponent of the tone curve about middle gray, 0.25 to 4; 1: none");
  visit("contrast_max", r.sensor.contrast_max, "largest contrast to draw, contrast_min to 4");

  visit("image_format", r.image_format,
        "format of the images: png, 8-bit sRGB; png_gray, 8 bits of a sensor without colours; jpeg, 8-bit "
        "sRGB with losses; exr, linear half floats without sensor noise");
  visit("jpeg_quality", r.jpeg_quality, "quality of jpeg images, 1 to 100; colours are not subsampled");
  visit("keep_masters", r.keep_masters,
        "true: keep every view's undistorted render as well, for cps train --online-lenses");
  visit("labels", r.labels,
        "dense labels to write beside every image, each through its lens: depth, distance, normal, instance, "
        "semantic, rays, up, latitude; any of them");
}

/// Keys that came later, with their defaults as text.
inline constexpr std::array<std::pair<std::string_view, std::string_view>, 9> later_recipe_keys{
    {{"contrast_min", "1"},
     {"contrast_max", "1"},
     {"camera_pitch_min_deg", "0"},
     {"camera_pitch_max_deg", "0"},
     {"camera_roll_min_deg", "0"},
     {"camera_roll_max_deg", "0"},
     {"lens_model", "brown_conrady"},
     {"real_lenses_share", "0"},
     {"sensor_binning", "1"}}};

/// The keys that describe a recipe in files, with their values: all but the later ones at their defaults, so
/// that the files of such recipes, dataset.json and jobs, keep the bytes from before there were these keys.
template <typename Visitor>
void for_each_written_key(const Recipe& recipe, Visitor&& visit) {
  for_each_recipe_key(recipe, [&](const char* key, const auto& value, const char* help) {
    using Later = std::pair<std::string_view, std::string_view>;
    const auto later = std::ranges::find(later_recipe_keys, std::string_view(key), &Later::first);
    if (later == later_recipe_keys.end() || later->second != value_text(value)) visit(key, value, help);
  });
}

}  // namespace cps
