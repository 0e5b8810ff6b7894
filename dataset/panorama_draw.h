#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "distortion/image_size.h"
#include "distortion/models/model_camera.h"
#include "numbers/interval.h"
#include "sampler/lenses/lens_options.h"
#include "sampler/part.h"

/// Draws cameras that look into equirectangular panoramas: real pixels with exact labels of any lens family,
/// pose against gravity included.
namespace cps {

struct PanoramaSetOptions {
  std::string family = "brown_conrady";  ///< or one of prior_families()
  /// Of the image: the label's for brown_conrady, what the picture really shows for the other families.
  Interval hfov_deg{60, 110};
  /// Of unified_spherical: the focal length at an image width of 299 pixels, which is then drawn in place of
  /// the H-FOV (as Bogdan et al. 2018 do, from 50 to 500). {0, 0}: it follows from the H-FOV.
  Interval focal_px{0, 0};
  Interval pitch_deg{-15, 15}, roll_deg{-10, 10};  ///< up and clockwise; yaw is uniform all around
  int views = 8;                                   ///< of each panorama
  ImageSize size{320, 240};
  std::uint64_t seed = 0;
  LensOptions lens = {};  ///< how Brown–Conrady lenses are drawn
  /// Empty if the options are usable; otherwise one line that names the field and the fix.
  std::string fault() const;
};

/// A panorama to draw views of.
struct PanoramaSource {
  std::string name;  ///< of its file, without the extension
  int width = 0;     ///< pixels
};

/// One image of the dataset. It has a lens, and so a leaf folder, of its own.
struct PanoramaView {
  std::string folder;  ///< <size>_panoramas/<name>_lens<number>
  ModelCamera camera;
  double yaw_rad = 0, pitch_rad = 0, roll_rad = 0;  ///< as panorama_from_camera() takes them
  Part part = Part::train;
  nlohmann::ordered_json label;  ///< the contents of calibration.json
};

/// The part of all views of a panorama: train, val or test with probabilities .70, .15 and .15, by a hash of
/// its name alone, so that it stays when files are added and whatever the seed. An ending like _4k is left
/// out of the name, since files that differ in it show one place.
Part part_of_panorama(std::string_view name);

/// Draws the panorama's views, numbered from 1, each a pure function of the options, the panorama's name and
/// width, and its number. A lens that is not certified on its whole frame, or that enlarges the panorama
/// anywhere by more than the warp's kernel allows, is drawn again with its H-FOV. Brown–Conrady lenses come
/// from draw_lens() by their label's H-FOV, the others from draw_model_lens(). With a focal_px the H-FOV is
/// that of the drawn focal length and lens. The label's T_vehicle_camera
/// is the camera's rotation from a level one that looks at the panorama's middle. Throws std::runtime_error
/// in one line when no lens is found.
std::vector<PanoramaView> draw_panorama_views(const PanoramaSource& panorama,
                                              const PanoramaSetOptions& options);

}  // namespace cps
