#include "dataset/job/finish.h"

#include <fmt/format.h>

#include <array>

#include "dataset/exchange/camera_json.h"
#include "dataset/job/frames.h"
#include "dataset/job/masters.h"
#include "dataset/job/recipe_json.h"
#include "dataset/job/write_label.h"
#include "dataset/labels/group_label.h"
#include "files/files.h"

namespace cps {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array parts = {Part::train, Part::val, Part::test};

Json conditions_json(const Plan& plan) {
  Json json = Json::array();
  for (const PlannedCondition& condition : plan.conditions)
    json.push_back({{"scene", plan.scenes[condition.scene].file.filename().string()},
                    {"date", date_text(condition.light.moment)},
                    {"time_utc", time_text(condition.light.moment)},
                    {"weather", to_string(condition.light.weather)},
                    {"sun_elevation_deg", condition.light.daylight.sun_elevation_deg},
                    {"sun_azimuth_deg", condition.light.daylight.sun_azimuth_deg},
                    {"turbidity", condition.light.daylight.turbidity}});
  return json;
}

Json class_json(const SemanticClass& label) {
  Json json = {{"id", label.id}};
  if (label.name.empty())
    json.update(Json{{"object", label.object}, {"material", label.material}});
  else
    json["name"] = label.name;
  json["has_instances"] = label.has_instances;
  return json;
}

Json scenes_json(const Plan& plan, const std::vector<std::string>& sha256) {
  Json json = Json::array();
  for (std::size_t s = 0; s < plan.scenes.size(); ++s) {
    const PlannedScene& scene = plan.scenes[s];
    Json entry = {{"file", scene.file.filename().string()}};
    if (scene.city)
      entry["city"] = {{"style", to_string(scene.city->style)},
                       {"seed", scene.city->seed},
                       {"traffic_seed", scene.city->traffic_seed},
                       {"traffic", scene.city->traffic}};
    entry["metres_per_unit"] = scene.metres_per_unit;
    if (scene.is_z_up) entry["up"] = "z";
    entry["credits"] = scene.credits;
    if (!scene.import_warnings.empty()) entry["import_warnings"] = scene.import_warnings;
    if (!scene.origin.isZero()) entry["origin_m"] = {scene.origin.x(), scene.origin.y(), scene.origin.z()};
    for (const SemanticClass& label : scene.classes) entry["classes"].push_back(class_json(label));
    entry["sha256"] = sha256[s];
    json.push_back(entry);
  }
  return json;
}

Json rig_json(const Rig& rig) {
  Json json = Json::array();
  for (const RigCamera& camera : rig.cameras)
    json.push_back(
        {{"name", camera.name}, {"T_vehicle_camera", rows_json(vehicle_from_camera(camera).matrix())}});
  return json;
}

Json places_json(const PlaceTally& places) {
  Json rejected_for;
  // The faults of light are rare: listed where they occur.
  for (int i = 1; i < place_fault_count; ++i)
    if (places.faults[i] > 0 || i <= static_cast<int>(PlaceFault::only_sky))
      rejected_for[to_string(static_cast<PlaceFault>(i))] = places.faults[i];
  return {{"drawn", places.drawn}, {"rejected", places.rejected()}, {"rejected_for", rejected_for}};
}

}  // namespace

bool is_finished(const std::filesystem::path& root) {
  return std::filesystem::exists(root / "dataset.json");
}

void finish_dataset(const std::filesystem::path& root, const Plan& plan,
                    const std::map<std::int64_t, ViewRecord>& records,
                    const std::vector<std::string>& scene_sha256) {
  std::vector<std::vector<Frame>> frames_of_group(plan.groups.size());
  std::array<std::string, 3> lists, pixel_lines;
  std::array<std::int64_t, 3> counts = {0, 0, 0};
  for (std::size_t v = 0; v < plan.views.size(); ++v) {
    const PlannedView& view = plan.views[v];
    const ViewRecord& record = records.at(static_cast<std::int64_t>(v));
    const auto part = static_cast<std::size_t>(view.part);
    for (std::size_t i = 0; i < record.images.size(); ++i) {
      const ImageRecord& image = record.images[i];
      frames_of_group[view.groups[i]].push_back({&view, &record, &image});
      lists[part] += image.file + "\n";
      pixel_lines[part] += image.file + " " + image.pixels_sha256 + "\n";
      ++counts[part];
    }
  }
  for (std::size_t g = 0; g < plan.groups.size(); ++g) {
    write_label(root, plan, plan.groups[g]);
    remove_temporaries(root / plan.groups[g].folder);
    write_file(root / plan.groups[g].folder / "frames.csv", frames_csv(frames_of_group[g]));
  }

  if (plan.recipe.keep_masters) {
    for (const PlannedSet& set : plan.sets) remove_temporaries(root / "masters" / set.folder);
    write_file(root / "masters.csv", masters_csv(plan, records));
  }
  for (const char* folder : {"scenes", "splits", ".cps"})
    if (std::filesystem::is_directory(root / folder)) remove_temporaries(root / folder);

  Json splits;
  for (Part part : parts) {
    const auto p = static_cast<std::size_t>(part);
    const std::string list = "splits/" + to_string(part) + ".txt";
    write_file(root / list, lists[p]);
    splits[to_string(part)] = {
        {"images", counts[p]}, {"list", list}, {"pixels_sha256", sha256(pixel_lines[p])}};
  }
  Json description = {{"schema", label_schema}, {"name", plan.recipe.name}};
  if (!plan.recipe.is_brown_conrady()) description.update(other_family_json(plan.recipe.lens_model));
  description.update(Json{{"generator", generator_name()},
                          {"seed", plan.recipe.seed},
                          {"recipe", recipe_json(plan.recipe)},
                          {"rig", rig_json(plan.rig)},
                          {"scenes", scenes_json(plan, scene_sha256)},
                          {"conditions", conditions_json(plan)},
                          {"sets", plan.sets.size()},
                          {"groups", plan.groups.size()},
                          {"views", plan.views.size()},
                          {"images", image_count(plan)},
                          {"places", places_json(plan.places)},
                          {"splits", splits}});
  write_json(root / "dataset.json", description);
}

}  // namespace cps
