#include "bench/scenes/view_classes.h"

#include <initializer_list>

namespace cps {
namespace {

struct Kind {
  ViewClass view_class;
  std::initializer_list<const char*> name_begins;
};

const Kind kinds[] = {
    {ViewClass::road, {"asphalt", "tar", "road_", "gutter", "manhole", "cycle_", "rail"}},
    {ViewClass::other_ground, {"paving", "kerb", "grass", "soil", "terrain"}},
    {ViewClass::vegetation, {"leaves", "fine_leaves", "needles", "bark", "hedge"}},
    {ViewClass::vehicle, {"car_", "tyre", "rim", "head_", "tail_", "number_", "bus_", "lorry_", "bicycle_"}},
    {ViewClass::other,
     {"pole", "lamp", "sign_", "signal_", "wood", "cloth", "skin", "hair", "fence", "container_", "cable",
      "mast"}},
};

ViewClass class_of(const std::string& material) {
  for (const Kind& kind : kinds)
    for (const char* begin : kind.name_begins)
      if (material.starts_with(begin)) return kind.view_class;
  return ViewClass::building;
}

}  // namespace

std::string to_string(ViewClass view_class) {
  constexpr const char* names[view_class_count] = {"sky",        "road",    "other ground", "building",
                                                   "vegetation", "vehicle", "other"};
  return names[static_cast<int>(view_class)];
}

std::vector<ViewClass> classes_of_materials(const Scene& city) {
  std::vector<ViewClass> classes{ViewClass::sky};
  for (const Material& material : city.materials) classes.push_back(class_of(material.name));
  return classes;
}

}  // namespace cps
