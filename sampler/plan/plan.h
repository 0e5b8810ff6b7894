#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "distortion/models/model_camera.h"
#include "sampler/lenses/lens_draw.h"
#include "sampler/part.h"
#include "sampler/places/place_draw.h"
#include "sampler/plan/scene_plan.h"
#include "sampler/recipe/recipe.h"
#include "scenes/drive/driven_scene.h"
#include "scenes/rig.h"

/// A recipe expanded to every condition, set, group and view, before anything is rendered. The plan is a pure
/// function of the recipe and the scenes' geometry. Only the places need the scenes: a process that makes a
/// few views outlines the plan and then places those (place_views.h).
namespace cps {

/// A scene in one light. Within a condition only pose and camera vary, so that it is loaded once.
struct PlannedCondition {
  int scene = 0;
  DrawnLight light;
};

/// One size at one H-FOV.
struct PlannedSet {
  std::string folder;   ///< 1392x512_hfov090; of another lens family 1392x512_kannala_brandt_hfov090
  int size = 0;         ///< index into the recipe's sizes
  double hfov_deg = 0;  ///< as in the recipe
  /// Output-sized and centred: base of all lenses of the set or, label-first, final camera. Of another lens
  /// family, whose angles no pinhole camera may have, the size alone.
  Pinhole camera;
};

/// Images that share size, rig camera, H-FOV and lens: one leaf folder.
struct PlannedGroup {
  std::string folder;  ///< <set folder>/front_lens0003
  int set = 0;
  int camera = 0;       ///< index into Plan::rig
  int lens_number = 0;  ///< unique in the dataset, except 0, the undistorted lens, in every set and camera
  Part part = Part::all;
  DrawnLens lens;
  /// Camera with a lens of another family than Brown–Conrady, nameless; then there is nothing in `lens`.
  std::optional<ModelCamera> model = {};
};

/// One render, and the groups that show it through their lenses. Views with the same set and index show the
/// same place through different cameras of the rig.
struct PlannedView {
  int set = 0;
  int index = 0;       ///< index of the place within the set; the file name of its images
  int rig_camera = 0;  ///< index into Plan::rig
  int condition = 0;
  Part part = Part::train;
  std::string street;  ///< set when the view is placed
  Place place;         ///< set when the view is placed
  RigCamera camera;    ///< with this view's mount errors, which are drawn with its place
  std::uint64_t seed = 0;
  Pinhole master;           ///< camera of the render for all its groups; empty where each image is traced
  std::vector<int> groups;  ///< indices into Plan::groups; the undistorted group comes first
};

struct Plan {
  Recipe recipe;
  Rig rig;  ///< without mount errors
  std::vector<PlannedScene> scenes;
  std::vector<PlannedCondition> conditions;
  std::vector<PlannedSet> sets;
  std::vector<PlannedGroup> groups;
  std::vector<PlannedView> views;  ///< sorted by condition, set, index, camera
  int distorted_lenses = 0;
  PlaceTally places;  ///< drawn so far
};

/// Number of images in the plan.
std::int64_t image_count(const Plan& plan);

/// The pixels that rendering a view takes: its master's or, where there is none, those of all its images.
double rendered_pixels(const Plan& plan, const PlannedView& view);

/// `000017.png`, with the extension of the recipe's image format.
std::string image_name(const Plan& plan, const PlannedView& view);

/// The indices of all its views, ascending.
std::vector<std::int64_t> all_views(const Plan& plan);

/// Expands a valid recipe for a rig to everything but the places of its views and what is set when a scene is
/// loaded. `scenes` are the recipe's scenes and cities; their files are not read.
Plan outline_plan(const Recipe& recipe, const Rig& rig, std::vector<PlannedScene> scenes);

/// Imports a scene's file for its places.
using LoadDrivenScene = std::function<DrivenScene(const std::filesystem::path&)>;

/// The whole plan: the outline with the places of all views. Loads scenes and throws as place_views() does.
Plan make_plan(const Recipe& recipe, const Rig& rig, std::vector<PlannedScene> scenes,
               const LoadDrivenScene& load);

}  // namespace cps
