#include <catch2/catch.hpp>

#include "dataset/labels/reader.h"
#include "dataset/verify/verify.h"
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
  CHECK(summary.worst_roundtrip_px < 1e-9);
  CHECK(summary.least_rim_margin_px > -1e-6);
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

TEST_CASE("verify knows the days of one city by its seed") {
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

TEST_CASE("what is no finished dataset is refused in one line") {
  CHECK_THROWS_WITH(verify_dataset("/nonexistent"), Catch::Contains("/nonexistent"));
  CHECK_THROWS_WITH(verify_dataset(TemporaryFolder().path), Catch::Contains("cps generate"));
  CHECK_THROWS_WITH(read_dataset(TemporaryFolder().path), Catch::Contains("calibration.json"));
}
