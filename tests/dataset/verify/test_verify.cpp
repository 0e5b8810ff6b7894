#include <catch2/catch.hpp>

#include "dataset/job/job.h"
#include "dataset/labels/reader.h"
#include "dataset/verify/verify.h"
#include "tests/dataset/edit_csv.h"
#include "tests/dataset/small_dataset.h"

using namespace cps;

namespace {

/// The dataset's faults joined, after `damage` was done to a fresh copy of it.
template <typename Damage>
std::string faults_after(Damage damage) {
  static const Plan plan = small_plan();
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  write_small_dataset(root, plan);
  damage(root, plan);
  std::string joined;
  for (const std::string& fault : verify_dataset(root).faults) joined += fault + "\n";
  return joined;
}

void replace_in(const std::filesystem::path& file, const std::string& from, const std::string& to) {
  std::string text = read_file(file);
  REQUIRE(text.find(from) != text.npos);
  text.replace(text.find(from), from.size(), to);
  write_file(file, text);
}

std::filesystem::path calibration(const std::filesystem::path& root, const Plan& plan, int group) {
  return root / plan.groups[group].folder / "calibration.json";
}

void change_label(const std::filesystem::path& file, const char* key, double value) {
  nlohmann::json json = read_json(file);
  json[key] = value;
  write_file(file, json.dump());
}

}  // namespace

TEST_CASE("a dataset written by the plan reads back and verifies") {
  const Plan plan = small_plan();
  const TemporaryFolder temporary;
  const auto& root = temporary.path;
  write_small_dataset(root, plan);
  const VerifySummary summary = verify_dataset(root);
  CHECK(summary.faults == std::vector<std::string>{});
  CHECK(summary.images == image_count(plan));
  CHECK(summary.groups == static_cast<std::int64_t>(plan.groups.size()));
  CHECK(summary.max_roundtrip_px < 1e-9);
  CHECK(summary.min_rim_margin_px > -1e-6);
  const Dataset dataset = read_dataset(root);
  CHECK(dataset.images.size() == static_cast<std::size_t>(image_count(plan)));
  for (const DatasetImage& image : dataset.images) {
    CHECK(std::filesystem::exists(root / image.file));
    CHECK(dataset.groups[image.group].folder == image.file.parent_path());
  }
}

TEST_CASE("the same plan gives the same files") {
  const TemporaryFolder folder_a, folder_b;
  const auto &a = folder_a.path, &b = folder_b.path;
  write_small_dataset(a, small_plan());
  write_small_dataset(b, small_plan());
  for (const auto& entry : std::filesystem::recursive_directory_iterator(a))
    if (entry.is_regular_file()) CHECK(read_file(entry) == read_file(b / entry.path().lexically_relative(a)));
}

TEST_CASE("verify names what is wrong with the files") {
  CHECK_THAT(faults_after([](auto& root, auto& plan) {
               std::filesystem::resize_file(root / plan.groups[0].folder / "000000.png", 200);
             }),
             Catch::Contains("000000.png: its bytes do not match"));
  CHECK_THAT(faults_after([](auto& root, auto& plan) {
               std::filesystem::remove(root / plan.groups[0].folder / "000001.png");
             }),
             Catch::Contains("000001.png"));
  CHECK_THAT(faults_after([](auto& root, auto& plan) {
               std::filesystem::copy_file(root / plan.groups[0].folder / "000001.png",
                                          root / plan.groups[0].folder / "000099.png");
             }),
             Catch::Contains("000099.png: is not in frames.csv"));
  CHECK_THAT(faults_after([](auto& root, auto&) {
               const std::string train = read_file(root / "splits" / "train.txt");
               write_file(root / "splits" / "test.txt",
                          read_file(root / "splits" / "test.txt") + train.substr(0, train.find('\n') + 1));
             }),
             Catch::Contains("stands in the split lists twice"));
  CHECK_THAT(faults_after([](auto& root, auto&) { write_file(root / "splits" / "val.txt", std::string()); }),
             Catch::Contains("stands in no split list"));
  CHECK_THAT(faults_after([](auto& root, auto& plan) {
               const auto csv = root / plan.groups[0].folder / "frames.csv";
               replace_in(csv, "train,0,street", "test,0,street");
             }),
             Catch::Contains("frames.csv says test") && Catch::Contains("occurs in"));
}

TEST_CASE("verify recognises the days of one city by the city's seed") {
  Recipe recipe;
  recipe.city_seeds = {1, 2};
  recipe.sizes = {{64, 36}};
  recipe.base_hfov_deg = {60};
  recipe.views = 60;
  const Plan plan = make_plan(recipe, Rig{}, plan_scenes(recipe, "cities"), [](const std::filesystem::path&) {
    return DrivenScene{.scene = plain_scene(6)};
  });
  const TemporaryFolder folder;
  write_small_dataset(folder.path, plan);
  CHECK(verify_dataset(folder.path).faults == std::vector<std::string>{});
  // Two cities deal their streets differently; as one city's days they must not.
  nlohmann::json description = read_json(folder.path / "dataset.json");
  description["scenes"][1]["city"]["seed"] = 1;
  write_file(folder.path / "dataset.json", description.dump());
  const std::vector<std::string> faults = verify_dataset(folder.path).faults;
  REQUIRE_FALSE(faults.empty());
  for (const std::string& fault : faults) CHECK_THAT(fault, Catch::Contains("occurs in"));
}

TEST_CASE("verify finds a label that was tampered with, however slightly") {
  const auto lens_group = [](const Plan& plan) {
    int g = 0;
    while (plan.groups[g].lens_number == 0) ++g;
    return g;
  };
  CHECK_THAT(faults_after([&](auto& root, auto& plan) {
               change_label(calibration(root, plan, lens_group(plan)), "fov_base_deg", 58.0);
             }),
             Catch::Contains("crop"));
  CHECK_THAT(faults_after([&](auto& root, auto& plan) {
               const auto file = calibration(root, plan, lens_group(plan));
               change_label(file, "k1", read_json(file)["k1"].template get<double>() + 1e-4);
             }),
             Catch::Contains("fov_true_deg"));
  CHECK_THAT(faults_after([&](auto& root, auto& plan) {
               change_label(calibration(root, plan, lens_group(plan)), "k1", 50.0);
             }),
             Catch::Contains("k1"));
  CHECK_THAT(faults_after([&](auto& root, auto& plan) {
               change_label(calibration(root, plan, lens_group(plan)), "k1", -50.0);
             }),
             Catch::Contains("not one-to-one"));
}

TEST_CASE("verify finds a pose that contradicts the vehicle's, and a field that cannot be read") {
  const auto after_adding = [](const char* column, double more) {
    return faults_after([&](auto& root, auto& plan) {
      add_to_column(root / plan.groups[0].folder / "frames.csv", column, more);
    });
  };
  CHECK_THAT(after_adding("camera_x_m", 1), Catch::Contains("000000.png: its camera is turned by"));
  CHECK_THAT(after_adding("vehicle_z_m", 1), Catch::Contains("its camera is turned by"));
  CHECK_THAT(after_adding("vehicle_heading_deg", 40), Catch::Contains("its camera is turned by"));
  CHECK_THAT(after_adding("camera_qw", .1), Catch::Contains("no unit quaternion"));
  for (const char* column : {"gravity_x", "gravity_y", "gravity_z"}) {
    CHECK_THAT(after_adding(column, 1e-4),
               Catch::Contains("000000.png: gravity_x…z: contradicts camera_qw…qz"));
    CHECK(after_adding(column, 1e-8).empty());
  }
  CHECK_THAT(faults_after([](auto& root, auto& plan) {
               edit_column(root / plan.groups[0].folder / "frames.csv", "condition",
                           [](const std::string&) { return "zero"; });
             }),
             Catch::Contains("frames.csv: line 2: condition: 'zero' is not a whole number"));
  CHECK_THAT(faults_after([](auto& root, auto& plan) {
               edit_column(root / plan.groups[0].folder / "frames.csv", "condition",
                           [](const std::string&) { return "7"; });
             }),
             Catch::Contains("000000.png: condition 7 is not in dataset.json"));
}

TEST_CASE("without mount errors the camera's pose is the vehicle's and T_vehicle_camera, exactly") {
  Recipe recipe = small_plan().recipe;
  recipe.mount_error_deg = recipe.mount_error_m = 0;
  const Plan plan = make_plan(recipe, Rig{}, {{.file = "plain.glb"}}, [](const std::filesystem::path&) {
    return DrivenScene{.scene = plain_scene(6)};
  });
  const TemporaryFolder folder;
  write_small_dataset(folder.path, plan);
  CHECK(verify_dataset(folder.path).faults == std::vector<std::string>{});
  add_to_column(folder.path / plan.groups[0].folder / "frames.csv", "camera_y_m", 1e-4);
  CHECK_FALSE(verify_dataset(folder.path).faults.empty());
}

TEST_CASE("a street whose name holds a line break, a comma and quotes is a street like any other") {
  const Plan plan =
      make_plan(small_plan().recipe, Rig{}, {{.file = "plain.glb"}}, [](const std::filesystem::path&) {
        Scene scene = plain_scene(6);
        for (Lane& lane : scene.lanes) lane.street += ",\n\"second\" line";
        return DrivenScene{.scene = scene};
      });
  const TemporaryFolder folder;
  write_small_dataset(folder.path, plan);
  CHECK(verify_dataset(folder.path).faults == std::vector<std::string>{});
}

TEST_CASE(
    "of a dataset without dataset.json and frames.csv, as cps relens makes, labels, lists and images are "
    "checked") {
  const auto strip = [](const std::filesystem::path& root, const Plan& plan) {
    std::filesystem::remove(root / "dataset.json");
    for (const PlannedGroup& group : plan.groups) std::filesystem::remove(root / group.folder / "frames.csv");
  };
  const TemporaryFolder folder;
  const Plan plan = small_plan();
  write_small_dataset(folder.path, plan);
  strip(folder.path, plan);
  const VerifySummary summary = verify_dataset(folder.path);
  CHECK(summary.faults == std::vector<std::string>{});
  CHECK(summary.images == image_count(plan));
  CHECK_THAT(summary.brief(), Catch::Contains("hashes of files not checked"));
  const auto stripped = [&](auto damage) {
    return faults_after([&](auto& root, auto& plan) {
      strip(root, plan);
      damage(root, root / plan.groups[0].folder);
    });
  };
  CHECK_THAT(stripped([](auto&, auto leaf) { std::filesystem::remove(leaf / "000001.png"); }),
             Catch::Contains("000001.png: cannot be decoded"));
  CHECK_THAT(stripped([](auto&, auto leaf) { std::filesystem::resize_file(leaf / "000001.png", 200); }),
             Catch::Contains("000001.png: cannot be decoded"));
  CHECK_THAT(stripped([](auto&, auto leaf) {
               std::filesystem::copy_file(leaf / "000001.png", leaf / "000099.png");
             }),
             Catch::Contains("000099.png: stands in no split list"));
  CHECK_THAT(stripped([](auto&, auto leaf) {
               OIIO::ImageBuf small(OIIO::ImageSpec(8, 8, 3, OIIO::TypeDesc::UINT8));
               write_file(leaf / "000001.png", encode_png(small));
             }),
             Catch::Contains("000001.png: its size contradicts calibration.json"));
  CHECK_THAT(stripped([](auto&, auto leaf) { change_label(leaf / "calibration.json", "k1", 50.0); }),
             Catch::Contains("calibration.json"));
}

TEST_CASE("a folder that is no finished dataset is refused in one line") {
  CHECK_THROWS_WITH(verify_dataset("/nonexistent"), Catch::Contains("/nonexistent"));
  CHECK_THROWS_WITH(verify_dataset(TemporaryFolder().path), Catch::Contains("calibration.json"));
  CHECK_THROWS_WITH(read_dataset(TemporaryFolder().path), Catch::Contains("calibration.json"));
  // Begun and not finished: to be gone on with.
  const TemporaryFolder folder;
  const Plan plan = small_plan();
  write_small_dataset(folder.path, plan);
  std::filesystem::remove(folder.path / "dataset.json");
  begin_job(folder.path, {.recipe = "", .rig = "", .drive = ""});
  CHECK_THROWS_WITH(verify_dataset(folder.path), Catch::Contains("is not finished; run cps generate again"));
  // Lost: cannot be made again.
  std::filesystem::remove_all(folder.path / ".cps");
  CHECK_THROWS_WITH(verify_dataset(folder.path), Catch::Contains("dataset.json: is missing"));
}
