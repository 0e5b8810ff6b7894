#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>
#include <map>

#include "scenes/city/blocks/block_plan.h"
#include "scenes/city/roadside/model_library.h"
#include "scenes/city/roadside/vehicles/vehicle.h"
#include "scenes/ego_bonnet.h"
#include "tests/scenes/city/labelled.h"
#include "tests/temporary_folder.h"

using namespace cps;
using namespace cps::city;
using Eigen::Vector3f;

namespace {

namespace fs = std::filesystem;

/// All models of the cities, one beside the other.
struct LabelledModels {
  static constexpr float apart_m = 40;
  TemporaryFolder folder;
  fs::path file = folder.path / "models.glb";
  GlbWriter writer;
  Materials materials = make_materials(writer, 0);
  ModelLibrary models = make_models(writer, materials, 0);
  std::vector<const Model*> placed;
  Labelled labelled = write();

  Labelled write() {
    const auto place = [&](const Model& model) {
      writer.add_node(model.name, model.mesh, {Vec3(apart_m * static_cast<double>(placed.size()), 0, 0)});
      placed.push_back(&model);
    };
    for (const Model* model :
         {&models.lamp, &models.tall_lamp, &models.bollard, &models.bin, &models.bench, &models.switch_box,
          &models.telegraph_mast, &models.span_mast, &models.bus_shelter, &models.bus_stop_sign,
          &models.traffic_light_red, &models.traffic_light_green})
      place(*model);
    for (const auto* list :
         {&models.boundaries, &models.goods, &models.signs, &models.far_houses, &models.people,
          &models.lorries, &models.buses, &models.bicycles, &models.cyclists, &models.motorcyclists})
      for (const Model& model : *list) place(model);
    for (const auto* lists : {&models.trees, &models.cars})
      for (const std::vector<Model>& list : *lists)
        for (const Model& model : list) place(model);
    writer.write(file, nlohmann::ordered_json::object());
    return Labelled(file);
  }

  /// The class seen from a point in a model's frame.
  std::string seen(const Model& model, const Vector3f& from, const Vector3f& direction) const {
    const auto at = std::find(placed.begin(), placed.end(), &model) - placed.begin();
    return labelled.seen(from + Vector3f(apart_m * static_cast<float>(at), 0, 0), direction);
  }
};

const LabelledModels& labelled_models() {
  static const LabelledModels shared;
  return shared;
}

/// The classes of each object's parts, by the object's name.
std::map<std::string, Names> classes_by_object(const Labelled& labelled) {
  std::map<std::string, Names> classes;
  for (int i = 0; i < static_cast<int>(labelled.scene.instances.size()); ++i)
    classes[labelled.object(i)].insert(labelled.class_of(i));
  return classes;
}

}  // namespace

TEST_CASE("a city has all of Cityscapes' classes, with its ids") {
  const std::vector<SemanticClass>& classes = labelled_models().labelled.classes.classes;
  REQUIRE(classes.size() == 34);
  for (int i = 0; i < 34; ++i) {
    CHECK(classes[i].id == i);
    CHECK(classes[i].has_instances == (i >= 24));
    CHECK(classes[i].object.empty());
    CHECK(classes[i].material.empty());
  }
  // From labels.py of cityscapesScripts.
  const std::map<int, std::string> known{
      {0, "unlabeled"},   {1, "ego vehicle"}, {4, "static"}, {7, "road"},           {8, "sidewalk"},
      {11, "building"},   {13, "fence"},      {17, "pole"},  {19, "traffic light"}, {20, "traffic sign"},
      {21, "vegetation"}, {22, "terrain"},    {23, "sky"},   {24, "person"},        {25, "rider"},
      {26, "car"},        {28, "bus"},        {31, "train"}, {32, "motorcycle"},    {33, "bicycle"}};
  for (const auto& [id, name] : known) CHECK(classes[id].name == name);
}

TEST_CASE("every model has the classes that Cityscapes gives to its parts") {
  const ModelLibrary& models = labelled_models().models;
  std::map<std::string, Names> expected{{"container", {"dynamic"}},
                                        {"container stack", {"dynamic"}},
                                        {"pallets", {"dynamic"}},
                                        {"silo", {"static"}}};
  const auto expect = [&](const std::vector<Model>& list, const Names& names) {
    for (const Model& model : list) expected[model.name] = names;
  };
  for (const std::vector<Model>& variants : models.trees) expect(variants, {"vegetation"});
  for (const std::vector<Model>& paints : models.cars) expect(paints, {"car"});
  expect(models.lorries, {"truck"});
  expect(models.buses, {"bus"});
  expect(models.bicycles, {"bicycle"});
  expect(models.cyclists, {"bicycle", "rider"});
  expect(models.motorcyclists, {"motorcycle", "rider"});
  expect(models.people, {"person"});
  expect(models.far_houses, {"building"});
  expect(models.signs, {"pole", "traffic sign"});
  expect({models.traffic_light_red, models.traffic_light_green}, {"pole", "traffic light"});
  expect({models.bus_stop_sign}, {"pole", "traffic sign"});
  expect({models.lamp, models.tall_lamp, models.telegraph_mast, models.bin}, {"pole", "static"});
  expect({models.span_mast, models.bollard}, {"pole"});
  expect({models.bench, models.switch_box}, {"static"});
  expect({models.bus_shelter}, {"building"});
  const auto boundary = [&](BoundaryKind kind) { return models.boundaries[static_cast<int>(kind)]; };
  expect({boundary(BoundaryKind::hedge)}, {"vegetation"});
  expect({boundary(BoundaryKind::picket_fence), boundary(BoundaryKind::mesh_fence)}, {"fence"});
  expect({boundary(BoundaryKind::low_wall), boundary(BoundaryKind::high_wall)}, {"wall"});
  CHECK(classes_by_object(labelled_models().labelled) == expected);
  CHECK(labelled_models().labelled.scene.objects.size() == labelled_models().placed.size());
}

TEST_CASE("rays meet the class of the part that is there") {
  const LabelledModels& all = labelled_models();
  const Vector3f to_left(0, 0, -1), forwards(0, 0, 1);
  for (std::size_t k = 0; k < vehicle_classes().size(); ++k) {
    const VehicleClass& c = vehicle_classes()[k];
    for (const double axle : {c.front_axle_m, c.rear_axle_m})  // the middle of a wheel
      CHECK(all.seen(all.models.cars[k][0],
                     {static_cast<float>(axle), static_cast<float>(c.wheel_radius_m), 3}, to_left) == "car");
  }
  for (const Model& model : all.models.cyclists) {
    CHECK(all.seen(model, {-0.1f, 1.22f, 3}, to_left) == "rider");     // the chest
    CHECK(all.seen(model, {0.54f, 0.672f, 3}, to_left) == "bicycle");  // the front tyre
  }
  for (const Model& model : all.models.motorcyclists) {
    CHECK(all.seen(model, {-0.2f, 1.14f, 3}, to_left) == "rider");
    CHECK(all.seen(model, {0.72f, 0.555f, 3}, to_left) == "motorcycle");
  }
  for (const Model& model : all.models.signs) {  // whose boards face −z
    CHECK(all.seen(model, {0.1f, 2.35f, -3}, forwards) == "traffic sign");
    CHECK(all.seen(model, {0.1f, 2.35f, 3}, -forwards) == "pole");  // the back of the board
    CHECK(all.seen(model, {0, 1, -3}, forwards) == "pole");
  }
  for (const Model* model : {&all.models.traffic_light_red, &all.models.traffic_light_green}) {
    CHECK(all.seen(*model, {0, 3.08f, -3}, forwards) == "traffic light");
    CHECK(all.seen(*model, {0, 1, -3}, forwards) == "pole");
  }
}

TEST_CASE("the bonnet in a city is the ego vehicle") {
  Scene scene = labelled_models().labelled.scene;
  add_ego_bonnet(scene);
  const SceneClasses classes = semantic_classes(scene);
  CHECK(classes.classes[classes.of_instance.back()].name == "ego vehicle");
  CHECK(classes.classes.size() == 34);
}

TEST_CASE("a city that another program has written counts as any other scene") {
  const LabelledModels& all = labelled_models();
  std::ifstream in(all.file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  const std::string ours = "\"generator\":\"cps city\"", other = "\"generator\":\"modeller\"";
  const std::size_t at = bytes.find(ours);
  REQUIRE(at != std::string::npos);
  bytes.replace(at, ours.size(), other);
  std::ofstream(all.folder.path / "other.glb", std::ios::binary) << bytes;
  const SceneClasses classes = semantic_classes(import_gltf(all.folder.path / "other.glb"));
  CHECK(classes.background == 0);
  CHECK(classes.classes.front().id == 1);
  CHECK(classes.classes.front().name.empty());
  CHECK(classes.classes.front().object == all.placed.front()->name);
}
