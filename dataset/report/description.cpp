#include "dataset/report/description.h"

#include "dataset/verify/dataset_files.h"
#include "files/json_keys.h"

namespace cps {
namespace {

std::int64_t count(const JsonKeys& keys, const std::string& key) {
  return static_cast<std::int64_t>(keys.unsigned_integer(key));
}

/// The objects of a list.
std::vector<JsonKeys> objects(const JsonKeys& keys, const std::string& key) {
  const nlohmann::json& list = keys.at(key);
  if (!list.is_array()) keys.fail(key, "must be a list");
  std::vector<JsonKeys> objects;
  for (const nlohmann::json& entry : list) objects.push_back({entry, keys.file});
  return objects;
}

Description::Scene scene_from(const JsonKeys& keys) {
  Description::Scene scene{.file = keys.text("file"),
                           .credits = keys.text("credits"),
                           .sha256 = keys.text("sha256"),
                           .metres_per_unit = keys.number("metres_per_unit")};
  if (keys.json.contains("city")) {
    const JsonKeys city = keys.object("city");
    scene.city = Description::City{.style = city.text("style"),
                                   .seed = city.unsigned_integer("seed"),
                                   .traffic_seed = city.unsigned_integer("traffic_seed"),
                                   .traffic = city.number("traffic")};
  }
  if (!keys.json.contains("import_warnings")) return scene;
  for (const nlohmann::json& warning : keys.at("import_warnings")) {
    if (!warning.is_string()) keys.fail("import_warnings", "must be a list of texts");
    scene.import_warnings.push_back(warning.get<std::string>());
  }
  return scene;
}

Description::Condition condition_from(const JsonKeys& keys, const nlohmann::json& scenes) {
  return {.scene = keys.text("scene"),
          .date = keys.text("date"),
          .time_utc = keys.text("time_utc"),
          .weather = keys.text("weather"),
          .sun_elevation_deg = keys.number("sun_elevation_deg"),
          .sun_azimuth_deg = keys.number("sun_azimuth_deg"),
          .turbidity = keys.number("turbidity"),
          .streets = streets_of(scenes, keys.json)};
}

Description::Places places_from(const JsonKeys& keys) {
  Description::Places places{.drawn = count(keys, "drawn"), .rejected = count(keys, "rejected")};
  const JsonKeys reasons = keys.object("rejected_for");
  for (const auto& [reason, number] : reasons.json.items())
    places.rejected_for.emplace_back(reason, count(reasons, reason));
  return places;
}

}  // namespace

Description description_from_json(const nlohmann::json& json, const std::string& file) {
  const JsonKeys keys{json, file};
  Description description{.name = keys.text("name"),
                          .generator = keys.text("generator"),
                          .schema = keys.unsigned_integer("schema"),
                          .seed = keys.unsigned_integer("seed"),
                          .recipe = {},
                          .rig = {},
                          .scenes = {},
                          .conditions = {},
                          .views = count(keys, "views"),
                          .pixels_sha256 = {}};
  const JsonKeys recipe = keys.object("recipe");
  for (const auto& [key, value] : recipe.json.items()) description.recipe.emplace_back(key, recipe.text(key));
  for (const JsonKeys& camera : objects(keys, "rig"))
    description.rig.push_back({camera.text("name"), camera.matrix("T_vehicle_camera", 4, 4)});
  for (const JsonKeys& scene : objects(keys, "scenes")) description.scenes.push_back(scene_from(scene));
  for (const JsonKeys& condition : objects(keys, "conditions"))
    description.conditions.push_back(condition_from(condition, keys.at("scenes")));
  if (json.contains("places")) description.places = places_from(keys.object("places"));
  const JsonKeys splits = keys.object("splits");
  for (Part part : {Part::train, Part::val, Part::test})
    description.pixels_sha256[static_cast<std::size_t>(part)] =
        splits.object(to_string(part)).text("pixels_sha256");
  return description;
}

}  // namespace cps
