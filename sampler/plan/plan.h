#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "sampler/lenses/lens_draw.h"
#include "sampler/part.h"
#include "sampler/places/place_draw.h"
#include "sampler/plan/scene_plan.h"
#include "sampler/recipe/recipe.h"
#include "scenes/drive/driven_scene.h"
#include "scenes/rig.h"

/// A recipe counted out: every condition, set, group and view, before anything is rendered. The plan is a
/// pure function of the recipe and the scenes' geometry.
namespace cps {

/// Scene and light. Within one only pose and camera vary, so it is loaded once.
struct PlannedCondition {
  int scene = 0;
  DrawnLight light;
};

/// One size at one H-FOV.
struct PlannedSet {
  std::string folder;  ///< 1392x512_hfov090
  int size = 0;        ///< index into the recipe's sizes
  Pinhole camera;      ///< output-sized, centred: the base of all its lenses, or, label-first, their image
};

/// Images that share size, rig camera, H-FOV and lens: one leaf folder.
struct PlannedGroup {
  std::string folder;  ///< <set folder>/front_lens0003
  int set = 0;
  int camera = 0;       ///< index into Plan::rig
  int lens_number = 0;  ///< unique in the dataset, but 0, the undistorted lens, is in every set and camera
  Part part = Part::all;
  DrawnLens lens;
};

/// One render and the groups that see it through their lenses. Views of one set and index are one place, seen
/// by the rig's cameras.
struct PlannedView {
  int set = 0;
  int index = 0;       ///< of the place within the set; the images' file name
  int rig_camera = 0;  ///< index into Plan::rig
  int condition = 0;
  Part part = Part::train;
  std::string street;
  Place place;
  RigCamera camera;  ///< with this view's mount errors
  std::uint64_t seed = 0;
  Pinhole master;           ///< what is rendered, for all its groups
  std::vector<int> groups;  ///< the undistorted one first, if there is one
};

struct Plan {
  Recipe recipe;
  Rig rig;  ///< as meant, without mount errors
  std::vector<PlannedScene> scenes;
  std::vector<PlannedCondition> conditions;
  std::vector<PlannedSet> sets;
  std::vector<PlannedGroup> groups;
  std::vector<PlannedView> views;  ///< by condition, then set, then index, then camera
  int distorted_lenses = 0;
  PlaceTally places;
};

/// Number of images the plan makes.
std::int64_t image_count(const Plan& plan);

/// `000017.png`, with the extension of the recipe's image format.
std::string image_name(const Plan& plan, const PlannedView& view);

/// Expands a valid recipe for the cars' rig. `scenes` are its scenes and cities, whose files exist; `load`
/// imports one (one is held at a time). Throws std::runtime_error when a scene has too few streets for three
/// parts or no clear places.
Plan make_plan(const Recipe& recipe, const Rig& rig, std::vector<PlannedScene> scenes,
               const std::function<DrivenScene(const std::filesystem::path&)>& load);

}  // namespace cps
