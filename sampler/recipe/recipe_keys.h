#pragma once

#include "sampler/recipe/lens_keys.h"
#include "sampler/recipe/light_keys.h"
#include "sampler/recipe/recipe.h"

namespace cps {

/// The one list of recipe keys: calls visit(key, member, help) for each. Reading, writing and help all come
/// from it, so a key is added here and nowhere else. RecipeT is Recipe or const Recipe.
template <typename RecipeT, typename Visitor>
void for_each_recipe_key(RecipeT& r, Visitor&& visit) {
  visit("name", r.name, "what the dataset calls itself");
  visit("seed", r.seed, "everything drawn follows from it");

  visit("scene", r.scenes,
        "glTF files, separated by commas; one without lanes is searched for ground to drive on");
  visit("city_seed", r.city_seeds, "procedural cities by seed, separated by commas");
  visit("cities", r.cities, "so many more procedural cities, whose seeds are drawn");
  visit("city_style", r.city_styles, "the cities' styles, in turn, separated by commas");
  visit("traffic_min", r.traffic_min, "least traffic of a city, times what its style has; 0: none");
  visit("traffic_max", r.traffic_max, "most; 2 at most");

  visit("conditions_per_scene", r.conditions_per_scene, "each has its own day, hour and weather");
  for_each_light_key(r.light, visit);

  visit("size", r.sizes, "image sizes in pixels, as 1392x512, separated by commas");
  visit("base_hfov_deg", r.base_hfov_deg, "H-FOVs of the masters, before the crop, separated by commas");
  visit("hfov_deg", r.hfov_deg,
        "instead: H-FOVs of the images, after the crop; each lens gets the base that leads there");
  visit("views", r.views, "views per size, H-FOV and camera: so many places; a number, or one per size");

  visit("rig", r.rig, "rig file, as named or beside the recipe; none: one camera, 1.65 m high");
  visit("ego_bonnet", r.ego_bonnet, "show the car's own bonnet; a network may then read the H-FOV off it");
  visit("mount_error_deg", r.mount_error_deg, "standard deviation of each camera's yaw, pitch and roll");
  visit("mount_error_m", r.mount_error_m, "standard deviation of each camera's position along each axis");
  visit("lateral_m", r.lateral_m, "standard deviation of the car's offset from its lane's middle");
  visit("heading_deg", r.heading_deg, "standard deviation of the car's heading off its lane's");
  visit("lane_change_share", r.lane_change_share,
        "share of places where the car is changing lanes, if it can");
  visit("clearance_m", r.clearance_m, "free way a place must have in front of a camera");
  visit("side_clearance_m", r.side_clearance_m, "the same for cameras more than 60 degrees off ahead");

  visit("lenses", r.lenses, "distorted images per view; a number, or one per size");
  visit("undistorted", r.undistorted, "every view once more, through no lens");
  visit("views_per_lens", r.views_per_lens, "a part draws new lenses after so many views; 0: never");
  for_each_lens_key(r.lens_options, visit);

  visit("train_share", r.train_share, "share of the views in train");
  visit("val_share", r.val_share, "share of the views in val; the rest is test");
  visit("split", r.split, "route: a street belongs to one part; thesis: random by view");

  visit("samples", r.samples,
        "rays per master pixel, even; an output pixel is as noisy as the mean of four times as many");
  visit("max_shaded_vertices", r.max_shaded_vertices, "surface points at which a path gathers light");
  visit("exposure_bias_min_ev", r.sensor.exposure_bias_min_ev, "darkest exposure against the meter");
  visit("exposure_bias_max_ev", r.sensor.exposure_bias_max_ev, "brightest exposure against the meter");
  visit("full_well_min_e", r.sensor.full_well_min_e, "fewest electrons at white (most shot noise)");
  visit("full_well_max_e", r.sensor.full_well_max_e, "most electrons at white");
  visit("read_noise_min_e", r.sensor.read_noise_min_e, "least read noise, rms electrons");
  visit("read_noise_max_e", r.sensor.read_noise_max_e, "most read noise");

  visit("image_format", r.image_format, "png, png_gray, jpeg, or exr: linear, without sensor noise");
  visit("jpeg_quality", r.jpeg_quality, "1 to 100, colours not subsampled");
  visit("keep_masters", r.keep_masters,
        "keep every view's undistorted render too, for cps train --online-lenses");
}

}  // namespace cps
