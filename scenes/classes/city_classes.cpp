#include "scenes/classes/city_classes.h"

#include <map>
#include <string_view>
#include <utility>

#include "scenes/classes/cityscapes.h"

namespace cps {
namespace {

using namespace cityscapes;

/// The class of an object and a material whose names fit; * stands for any text.
struct Rule {
  std::string_view object, material;
  Id is;
};

/// The first rule that fits counts. Grounds list their materials, so that a new one stays unlabeled and a
/// test fails.
constexpr Rule rules[] = {
    {"ego vehicle", "*", ego_vehicle},
    // Vehicles and people. A rider's shoes and helmet have the materials of the vehicle.
    {"hatchback", "*", car},
    {"saloon", "*", car},
    {"estate", "*", car},
    {"off-roader", "*", car},
    {"city car", "*", car},
    {"people carrier", "*", car},
    {"van", "*", car},
    {"lorry", "*", truck},
    {"bus", "*", bus},
    {"*cyclist", "cloth_*", rider},
    {"*cyclist", "skin_*", rider},
    {"*cyclist", "hair_*", rider},
    {"cyclist", "*", bicycle},
    {"bicycle", "*", bicycle},
    {"motorcyclist", "*", motorcycle},
    {"person", "*", person},
    // Plants: trees bear the names of their species.
    {"*", "bark", vegetation},
    {"*", "birch_bark", vegetation},
    {"*", "leaves*", vegetation},
    {"*", "fine_leaves*", vegetation},
    {"*", "needles*", vegetation},
    {"hedge", "hedge_core", vegetation},
    // Along the streets. Lamps are static, but their housings share the material of their poles.
    {"street lamp", "lamp_glass", fixed_thing},
    {"street lamp", "pole", pole},
    {"telegraph mast", "lamp_glass", fixed_thing},
    {"telegraph mast", "*", pole},
    {"span mast", "*", pole},
    {"bollard", "*", pole},
    {"traffic sign", "pole", pole},
    {"traffic sign", "*", traffic_sign},
    {"bus stop sign", "pole", pole},
    {"bus stop sign", "*", traffic_sign},
    {"traffic light", "pole", pole},
    {"traffic light", "*", traffic_light},
    {"wires *", "*", fixed_thing},
    {"tram wires *", "*", fixed_thing},
    {"bin", "pole", pole},
    {"bin", "*", fixed_thing},
    {"bench", "*", fixed_thing},
    {"switch box", "*", fixed_thing},
    {"bus shelter", "*", building},
    {"picket fence", "*", fence},
    {"mesh fence", "*", fence},
    {"low wall", "*", wall},
    {"high wall", "*", wall},
    {"container*", "*", movable_thing},
    {"pallets", "*", movable_thing},
    {"silo", "*", fixed_thing},
    // Roads, with their markings and what lies in them: cycle lanes that no kerb divides off, and rails of
    // trams.
    {"street *", "asphalt*", road},
    {"street *", "tar", road},
    {"street *", "manhole", road},
    {"markings *", "road_paint", road},
    {"cycle tracks *", "cycle_track", road},
    {"cycle tracks *", "road_paint", road},
    {"tram track *", "rail", road},
    {"tram track *", "tar", road},
    {"tram track *", "manhole", road},
    {"junction * island", "grass", terrain},
    {"junction * island", "paving", sidewalk},
    {"junction * island", "kerb", sidewalk},
    {"junction *", "asphalt*", road},
    {"junction *", "road_paint", road},
    {"junction *", "tar", road},
    {"junction *", "manhole", road},
    {"median *", "grass", terrain},
    {"median *", "paving", sidewalk},
    {"median *", "kerb", sidewalk},
    {"pavement tracks *", "cycle_track", sidewalk},
    {"pavement tracks *", "road_paint", sidewalk},
    // Blocks. Yards serve lorries, parking and walking alike: Cityscapes' ground.
    {"block * building *", "*", building},
    {"block *", "gutter", road},
    {"block *", "kerb", sidewalk},
    {"block *", "paving", sidewalk},
    {"block *", "grass", terrain},
    {"block *", "asphalt", ground},
    {"block *", "concrete", ground},
    {"far house *", "*", building},
    {"terrain", "terrain", terrain},
};

bool fits(std::string_view text, std::string_view pattern) {
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return text == pattern;
  if (!text.starts_with(pattern.substr(0, star))) return false;
  const std::string_view rest = pattern.substr(star + 1);
  if (rest.empty()) return true;
  for (std::size_t from = star; from < text.size(); ++from)
    if (fits(text.substr(from), rest)) return true;
  return false;
}

Id class_of(std::string_view object, std::string_view material) {
  for (const Rule& rule : rules)
    if (fits(object, rule.object) && fits(material, rule.material)) return rule.is;
  return unlabeled;
}

}  // namespace

bool is_procedural_city(const Scene& scene) {
  return scene.generator == "cps city";
}

SceneClasses city_classes(const Scene& scene) {
  SceneClasses result{.classes = {}, .of_instance = {}, .background = sky};
  for (std::size_t id = 0; id < names.size(); ++id)
    result.classes.push_back(
        {.id = static_cast<int>(id), .name = names[id], .has_instances = has_instances(static_cast<Id>(id))});
  std::map<std::pair<std::string_view, int>, Id> known;  // many objects share a name
  for (const Instance& instance : scene.instances) {
    const int material = scene.meshes[instance.mesh].material;
    const std::string_view object = scene.objects[instance.object];
    const auto [found, is_new] = known.try_emplace({object, material}, unlabeled);
    if (is_new) found->second = class_of(object, scene.materials[material].name);
    result.of_instance.push_back(found->second);
  }
  return result;
}

}  // namespace cps
