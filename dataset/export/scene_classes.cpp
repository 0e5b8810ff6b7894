#include "dataset/export/scene_classes.h"

#include "files/json_keys.h"

namespace cps {
namespace {

using Json = nlohmann::ordered_json;

Json class_json(const JsonKeys& keys) {
  Json json = {{"id", keys.unsigned_integer("id")}};
  if (keys.json.contains("name"))
    json["name"] = keys.text("name");
  else
    for (const char* key : {"object", "material"}) json[key] = keys.text(key);
  if (!keys.at("has_instances").is_boolean()) keys.fail("has_instances", "must be true or false");
  json["has_instances"] = keys.at("has_instances").get<bool>();
  return json;
}

}  // namespace

nlohmann::ordered_json scene_classes(const ExportSource& source) {
  const std::string file = (source.dataset().root / "dataset.json").string();
  Json json = {{"conditions", Json::array()}, {"scenes", Json::object()}};
  for (const nlohmann::json& entry : source.files.list("scenes")) {
    const JsonKeys scene{entry, file};
    if (!scene.at("classes").is_array()) scene.fail("classes", "must be a list");
    Json& classes = json["scenes"][scene.text("file")] = Json::array();
    for (const nlohmann::json& listed : scene.at("classes")) classes.push_back(class_json({listed, file}));
  }
  for (const nlohmann::json& entry : source.files.list("conditions")) {
    const JsonKeys condition{entry, file};
    const std::string scene = condition.text("scene");
    if (!json["scenes"].contains(scene)) condition.fail("scene", scene + " is none of the scenes");
    json["conditions"].push_back(scene);
  }
  return json;
}

}  // namespace cps
