#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <set>
#include <tuple>

#include "dataset/export/coco_categories.h"
#include "tests/dataset/export/coco_masks.h"
#include "tests/dataset/export/exported.h"
#include "tests/dataset/export/stopped_export.h"

using namespace cps;
namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

constexpr std::array parts = {Part::train, Part::val, Part::test};

Json annotations(const fs::path& out, Part part) {
  return read_json(out / "annotations" / ("instances_" + to_string(part) + ".json"));
}

/// The 16-bit values of a PNG, read by OpenImageIO alone.
std::vector<std::uint16_t> values_in(const fs::path& png) {
  const auto in = OIIO::ImageInput::open(png.string());
  REQUIRE(in);
  REQUIRE(in->spec().nchannels == 1);
  std::vector<std::uint16_t> values(in->spec().image_pixels());
  REQUIRE(in->read_image(0, 0, 0, 1, OIIO::TypeDesc::UINT16, values.data()));
  return values;
}

/// Puts other pixels into a label's file, and its hash into frames.csv.
void replace_label(const fs::path& root, const fs::path& image, DenseLabel label, const Pinhole& camera) {
  const std::string bytes = encode_dense(made_up_label(label, camera, 0), label);
  write_file(root / dense_file(image, label), bytes);
  CsvTable table = read_csv(root / image.parent_path() / "frames.csv");
  const std::size_t file = table.column("file"), hash = table.column((to_string(label) + "_sha256").c_str());
  for (std::vector<std::string>& row : table.rows)
    if (row[file] == image.filename()) row[hash] = sha256(bytes);
  write_csv(table);
}

std::size_t images_of(const fs::path& root, Part part) {
  return std::ranges::count(read_dataset(root).images, part, &DatasetImage::part);
}

}  // namespace

TEST_CASE("annotations are the pixels of one object and class, with their box and area; none is missing") {
  const Labelled exported(ExportTarget::coco);
  const Dataset dataset = read_dataset(exported.root);
  std::size_t compared = 0;
  for (Part part : parts) {
    const Json coco = annotations(exported.out, part);
    std::map<std::int64_t, fs::path> files;
    std::map<std::tuple<std::int64_t, int, int>, std::int64_t> areas;  // by image, object and class
    for (const Json& image : coco.at("images")) {
      const auto id = image.at("id").get<std::int64_t>();
      const fs::path file = files[id] = exported.root / image.at("file_name").get<std::string>();
      const std::vector<std::uint16_t> objects = values_in(dense_file(file, DenseLabel::instance)),
                                       classes = values_in(dense_file(file, DenseLabel::semantic));
      for (std::size_t i = 0; i < objects.size(); ++i)
        if (objects[i] != 0 && classes[i] >= 24) ++areas[{id, objects[i], classes[i]}];
    }
    CHECK(files.size() == images_of(exported.root, part));
    std::set<std::int64_t> ids;
    for (const Json& annotation : coco.at("annotations")) {
      const std::int64_t image = annotation.at("image_id");
      const int object = annotation.at("cps").at("instance"), class_id = annotation.at("category_id");
      INFO(files.at(image) << ", object " << object << ", class " << class_id);
      CHECK(annotation.at("iscrowd") == 0);
      const auto id = annotation.at("id").get<std::int64_t>();
      CHECK(id > 0);
      CHECK(ids.insert(id).second);
      const std::vector<std::uint16_t> objects = values_in(dense_file(files.at(image), DenseLabel::instance)),
                                       classes = values_in(dense_file(files.at(image), DenseLabel::semantic));
      const std::vector<bool> mask = coco_mask(annotation.at("segmentation"));
      REQUIRE(mask.size() == objects.size());
      const int width = annotation.at("segmentation").at("size").at(1);
      int wrong = 0, left = width, right = -1, top = static_cast<int>(mask.size()), bottom = -1;
      for (int i = 0; i < static_cast<int>(mask.size()); ++i) {
        wrong += mask[i] != (objects[i] == object && classes[i] == class_id);
        if (!mask[i]) continue;
        left = std::min(left, i % width), right = std::max(right, i % width);
        top = std::min(top, i / width), bottom = std::max(bottom, i / width);
      }
      CHECK(wrong == 0);
      CHECK(annotation.at("bbox") == Json{left, top, right - left + 1, bottom - top + 1});
      const auto area = areas.find({image, object, class_id});
      REQUIRE(area != areas.end());
      CHECK(annotation.at("area") == area->second);
      areas.erase(area);
      ++compared;
    }
    CHECK(areas.empty());
  }
  CHECK(compared > 100);
}

TEST_CASE("a split lists its images in the dataset's order, with the numbers of their labels") {
  const Labelled exported(ExportTarget::coco);
  const Dataset dataset = read_dataset(exported.root);
  std::set<std::int64_t> ids;
  for (Part part : parts) {
    const Json coco = annotations(exported.out, part);
    CHECK_THAT(coco.at("info").at("description").get<std::string>(),
               Catch::Contains("exact camera calibrations"));
    CHECK(coco.at("licenses").is_array());
    std::size_t next = 0;
    for (const DatasetImage& image : dataset.images) {
      if (image.part != part) continue;
      const Json& listed = coco.at("images").at(next++);
      CHECK(ids.insert(listed.at("id").get<std::int64_t>()).second);
      CHECK(listed.at("file_name") == image.file.string());
      const Label& label = dataset.groups[image.group].label;
      CHECK(listed.at("width") == label.camera.width);
      CHECK(listed.at("height") == label.camera.height);
      CHECK(listed.at("cps").at("k1") == label.distortion.k1);
      CHECK(listed.at("cps").at("group") == dataset.groups[image.group].folder.string());
      CHECK(fs::equivalent(exported.out / to_string(part) / image.file, exported.root / image.file));
    }
    CHECK(next == coco.at("images").size());
  }
  CHECK(ids.size() == dataset.images.size());
}

TEST_CASE(
    "Cityscapes' classes whose things are counted are the categories, under its ids and in its groups") {
  const Labelled exported(ExportTarget::coco);
  for (Part part : parts)
    CHECK(annotations(exported.out, part).at("categories") ==
          Json::parse(R"([{"id": 24, "name": "person", "supercategory": "human"},
                          {"id": 25, "name": "rider", "supercategory": "human"},
                          {"id": 26, "name": "car", "supercategory": "vehicle"},
                          {"id": 33, "name": "bicycle", "supercategory": "vehicle"}])"));
}

TEST_CASE("an object and material of two scenes are one category, beside a city's") {
  const auto classes = nlohmann::ordered_json::parse(R"({
    "conditions": ["b", "city", "a", "b"],
    "scenes": {
      "a": [{"id": 1, "object": "Tree", "material": "bark", "has_instances": true},
            {"id": 2, "object": "Tree", "material": "leaves", "has_instances": true}],
      "city": [{"id": 7, "name": "road", "has_instances": false},
               {"id": 26, "name": "car", "has_instances": true}],
      "b": [{"id": 1, "object": "Tree", "material": "leaves", "has_instances": true},
            {"id": 2, "object": "", "material": "bark", "has_instances": true},
            {"id": 3, "object": "Ground", "material": "bark", "has_instances": false}]}})");
  const CocoCategories categories = coco_categories(classes);
  CHECK(Json(categories.list) == Json::parse(R"([{"id": 26, "name": "car", "supercategory": "vehicle"},
    {"id": 27, "name": "Tree/bark", "supercategory": "Tree"},
    {"id": 28, "name": "Tree/leaves", "supercategory": "Tree"},
    {"id": 29, "name": "/bark", "supercategory": ""}])"));
  using OfClass = std::map<int, std::optional<int>>;
  const OfClass a = {{0, {}}, {1, 27}, {2, 28}}, b = {{0, {}}, {1, 28}, {2, 29}, {3, {}}};
  CHECK(categories.of_class == std::vector<OfClass>{b, {{0, {}}, {7, {}}, {26, 26}}, a, b});

  auto odd = classes;
  odd["scenes"]["a"] = nlohmann::ordered_json::parse(R"([{"id": 26, "name": "cat", "has_instances": true}])");
  CHECK_THROWS_WITH(coco_categories(odd),
                    "dataset.json: the class 26 is cat in one scene and car in another");
}

TEST_CASE("a finished annotation file is kept if it is what was written, and made again if not") {
  const Labelled exported;
  const std::size_t train = images_of(exported.root, Part::train);
  const ExportOptions options{.target = ExportTarget::coco};
  CHECK_THROWS_AS(exported.write(exported.out, options, stop_after(train)), Stopped);
  const fs::path file = exported.out / "annotations/instances_train.json";
  CHECK_FALSE(fs::exists(file));
  CHECK_THROWS_AS(exported.write(exported.out, options, stop_after(train + 1)), Stopped);
  CHECK_FALSE(fs::exists(exported.out / "annotations/instances_val.json"));
  const std::string good = read_file(file);
  const auto old = fs::last_write_time(file) - std::chrono::hours(1);
  fs::last_write_time(file, old);
  CHECK_THROWS_AS(exported.write(exported.out, options, stop_after(1)), Stopped);
  CHECK(fs::last_write_time(file) == old);

  std::string bad = good;
  bad[bad.size() / 2] ^= 1;
  write_file(file, bad);
  exported.write(exported.out, options);
  CHECK(read_file(file) == good);
}

TEST_CASE("datasets without instance and semantic labels are refused, and nothing is written") {
  const Exported exported;
  const auto refuses = [&](const char* missing) {
    CHECK_THROWS_WITH(exported.write(exported.out, {.target = ExportTarget::coco}),
                      exported.root.string() + ": has no dense label " + missing +
                          ", which --to coco needs: make it with labels = instance, semantic in its recipe");
    CHECK_FALSE(fs::exists(exported.out));
  };
  refuses("instance");
  add_dense_labels(exported.root, std::array{DenseLabel::depth, DenseLabel::instance});
  refuses("semantic");
}

TEST_CASE(
    "damaged labels and classes that dataset.json does not tell stop the export before a file is written") {
  const Labelled exported;
  const Dataset dataset = read_dataset(exported.root);
  const fs::path image = dataset.images.front().file, instance = dense_file(image, DenseLabel::instance);
  const auto refuses = [&](const std::string& expected) {
    CHECK_THROWS_WITH(exported.write(exported.out, {.target = ExportTarget::coco}),
                      Catch::Contains(expected));
    for (const auto& [name, content] : bytes_of(exported.out))
      CHECK_FALSE((name.starts_with("annotations") || name == "export.json"));
    fs::remove_all(exported.out);
  };
  const std::string good = read_file(exported.root / instance);
  std::string bad = good;
  bad[bad.size() / 2] ^= 1;
  write_file(exported.root / instance, bad);
  refuses(instance.string() + ": its hash is not that in frames.csv");
  fs::remove(exported.root / instance);
  refuses(instance.string());
  replace_label(exported.root, image, DenseLabel::instance, {.width = 8, .height = 8});
  refuses(instance.string() + ": has another size than its image");
  replace_label(exported.root, image, DenseLabel::instance,
                dataset.groups[dataset.images.front().group].label.camera);
  CHECK(read_file(exported.root / instance) == good);

  Json classes = some_classes();
  classes.erase(5);
  write_classes(exported.root, classes);
  refuses("has the class 26, which dataset.json does not list for its scene");
  write_classes(exported.root, Json::parse(R"([{"id": 26, "name": "car"}])"));
  refuses("dataset.json: has_instances: is missing");
  write_classes(exported.root, nullptr);
  refuses("dataset.json: classes: must be a list");
  write_classes(exported.root, some_classes());
  exported.write(exported.out, {.target = ExportTarget::coco});
}
