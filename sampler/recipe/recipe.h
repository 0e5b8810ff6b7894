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
#include "sampler/recipe/dense_label.h"
#include "sampler/recipe/image_format.h"
#include "sampler/recipe/light_method.h"
#include "sampler/recipe/per_size.h"
#include "scenes/city/city_style.h"
#include "sensor/sensor.h"

/// What a person asks for. A recipe file is `key = value` lines (# starts a comment); every key is also an
/// option of `cps generate`, which overrides the file.
namespace cps {

struct Recipe {
  std::string name = "dataset";
  std::uint64_t seed = 0;

  // Scenes.
  std::vector<std::string> scenes;                          ///< glTF files
  std::vector<std::uint64_t> city_seeds;                    ///< seeds of procedural cities
  int cities = 0;                                           ///< number of further cities, with drawn seeds
  std::vector<CityStyle> city_styles{CityStyle::european};  ///< used in turn
  double traffic_min = 0.3, traffic_max = 1.7;              ///< range to draw from, times the style's traffic

  // Conditions: a scene in a drawn light.
  int conditions_per_scene = 1;
  LightOptions light;

  // Sets: every size at every H-FOV. Either base_hfov_deg or hfov_deg is given.
  std::vector<ImageSize> sizes;
  std::vector<double> base_hfov_deg;
  std::vector<double> hfov_deg;  ///< of other families: what the images show along their middle row
  PerSize views = 0;             ///< places per set, each seen by every camera of the rig

  // The car.
  std::string rig;               ///< rig file; empty: one camera, front
  bool ego_bonnet = false;       ///< show the car's own bonnet, whose outline tells the H-FOV
  double mount_error_deg = 1.0;  ///< standard deviation of each camera's drawn yaw, pitch and roll
  double mount_error_m = 0.01;   ///< standard deviation of each camera's position along each axis
  /// Ranges of a turn of each camera, drawn for each place and added to its pose on the car: up, clockwise.
  double camera_pitch_min_deg = 0, camera_pitch_max_deg = 0;
  double camera_roll_min_deg = 0, camera_roll_max_deg = 0;
  double lateral_m = 0.25;         ///< standard deviation of the car's offset from the lane's centre line
  double heading_deg = 3.0;        ///< standard deviation of the car's heading off the lane's direction
  double lane_change_share = 0.1;  ///< among the places with a lane beside in the same direction
  /// Free distance in front of a camera; a place with less is drawn again. Cameras that look more than 60°
  /// away from the driving direction need less, as parked cars and walls stand beside a lane.
  double clearance_m = 2.5, side_clearance_m = 0.8;

  // Lenses. Train, val and test have different ones.
  PerSize lenses = 0;                        ///< distorted images per view
  bool undistorted = true;                   ///< one more image per view, without distortion
  int views_per_lens = 0;                    ///< number of views of a part that share lenses; 0: all
  std::string lens_model = "brown_conrady";  ///< family of the lenses: this or one of prior_families()
  LensOptions lens_options;                  ///< how brown_conrady lenses are drawn

  // Parts: `route` gives each street to train, val or test; `thesis` splits by view, so that they share
  // streets.
  double train_share = 0.70, val_share = 0.15;
  std::string split = "route";

  // Rendering and the sensor.
  /// Paths per master pixel, even; an output pixel is as noisy as the mean of four times as many.
  /// Through lenses of other families, which have no master, an image pixel has four times as many paths.
  int samples = 16;
  int max_shaded_vertices = 5;
  LightMethod light_method = LightMethod::traced;
  SensorOptions sensor;

  // Files.
  ImageFormat image_format = ImageFormat::png;
  int jpeg_quality = 95;
  bool keep_masters = false;       ///< write every view's master, so that training can draw lenses of its own
  std::vector<DenseLabel> labels;  ///< written for every image; in the enum's order, each once

  bool is_brown_conrady() const { return lens_model == "brown_conrady"; }
  CropOrder crop_order() const { return hfov_deg.empty() ? CropOrder::base_first : CropOrder::label_first; }

  /// Empty if the recipe is usable; otherwise one line that names the key and its range.
  std::string fault() const;
};

/// Every key as a string-valued option with its help text and default, for files and the command line alike.
boost::program_options::options_description recipe_options();

/// Adds a recipe file's keys to `values`; what is there already (from the command line) stays, and if that
/// names scenes or cities, the file's scenes and cities are left out. Keys may be written with `-` for `_`.
/// Throws std::runtime_error: file, key, fix.
void store_recipe_file(const std::filesystem::path& file, boost::program_options::variables_map& values);

/// The recipe with these keys, scaled by `scale`; without the key `undistorted`, that is false for other lens
/// families than brown_conrady. Checks the recipe, and that a lens exists for each of its sets.
/// Throws std::runtime_error: key, value, fix.
Recipe recipe_from(const boost::program_options::variables_map& values);

/// The recipe as a file that reads back to the same recipe: every key of for_each_written_key(), one a line.
std::string to_text(const Recipe& recipe);

}  // namespace cps
