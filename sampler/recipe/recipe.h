#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "distortion/image_size.h"
#include "sampler/lenses/lens_draw.h"
#include "sampler/light_draw.h"
#include "sampler/recipe/image_format.h"
#include "sampler/recipe/per_size.h"
#include "scenes/city/city_style.h"
#include "sensor/sensor.h"

/// What a person asks for. A recipe file is `key = value` lines (# starts a comment); every key is also a
/// flag of `cps generate`, and a flag overrides the file.
namespace cps {

struct Recipe {
  std::string name = "dataset";
  std::uint64_t seed = 0;

  // Scenes.
  std::vector<std::string> scenes;                          ///< glTF files
  std::vector<std::uint64_t> city_seeds;                    ///< procedural cities, made when needed
  int cities = 0;                                           ///< so many more, whose seeds are drawn
  std::vector<CityStyle> city_styles{CityStyle::european};  ///< of all of them, in turn
  double traffic_min = 0.3, traffic_max = 1.7;  ///< drawn for each: times what its style has on its lanes

  // Conditions: each scene in so many lights.
  int conditions_per_scene = 1;
  LightOptions light;

  // Sets: every size at every H-FOV, which is either the bases' or the labels'.
  std::vector<ImageSize> sizes;
  std::vector<double> base_hfov_deg;
  std::vector<double> hfov_deg;
  PerSize views = 0;  ///< places per set, each seen by every camera of the rig

  // The car.
  std::string rig;                 ///< a rig file; none: one camera, front
  bool ego_bonnet = false;         ///< the car's own bonnet in the picture: its outline tells the H-FOV
  double mount_error_deg = 1.0;    ///< standard deviation of each camera's drawn yaw, pitch and roll
  double mount_error_m = 0.01;     ///< standard deviation of its position along each axis
  double lateral_m = 0.25;         ///< standard deviation of the car's offset from the lane's centre line
  double heading_deg = 3.0;        ///< standard deviation of the car's heading off the lane's direction
  double lane_change_share = 0.1;  ///< of the places beside another lane that leads the same way
  /// A place with less free way in front of a camera is drawn again; cameras that look more than 60° off the
  /// driving direction need less, as parked cars and walls stand beside a lane.
  double clearance_m = 2.5, side_clearance_m = 0.8;

  // Lenses. Each part of the split has its own.
  PerSize lenses = 0;       ///< distorted images per view
  bool undistorted = true;  ///< one more image per view, through no lens
  int views_per_lens = 0;   ///< after so many views a part draws new lenses; 0: never
  LensOptions lens_options;

  // Parts: `route` gives whole streets to train, val or test; `thesis` splits by view and shares streets.
  double train_share = 0.70, val_share = 0.15;
  std::string split = "route";

  // Rendering and the sensor.
  int samples =
      16;  ///< per master pixel, even; an output pixel is as noisy as the mean of four times as many
  int max_shaded_vertices = 5;
  SensorOptions sensor;

  // Files.
  ImageFormat image_format = ImageFormat::png;
  int jpeg_quality = 95;
  bool keep_masters = false;  ///< of every view, so that training can draw lenses of its own

  CropOrder crop_order() const { return hfov_deg.empty() ? CropOrder::base_first : CropOrder::label_first; }

  /// One line that names the key and its range when something is off.
  bool is_valid(std::string* why) const;
};

/// Every key as a string-valued option with its help text and default, for files and flags alike.
boost::program_options::options_description recipe_options();

/// Adds a recipe file's keys to `values`; what is there already (flags) stays. Throws std::runtime_error:
/// file, key, fix.
void store_recipe_file(const std::filesystem::path& file, boost::program_options::variables_map& values);

/// The recipe that these keys make, made smaller if `scale` says so: checked, and at least one lens found for
/// each of its sets. Throws std::runtime_error: key, value, fix.
Recipe recipe_from(const boost::program_options::variables_map& values);

/// The recipe as a file that reads back to the same recipe: every key, one a line.
std::string to_text(const Recipe& recipe);

}  // namespace cps
