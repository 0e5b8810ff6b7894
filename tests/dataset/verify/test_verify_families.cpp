#include <catch2/catch.hpp>

#include "dataset/contact_sheet.h"
#include "dataset/export/source.h"
#include "dataset/job/recipe_json.h"
#include "dataset/job/write_label.h"
#include "dataset/migrate/migrate.h"
#include "dataset/report/page.h"
#include "dataset/verify/verify.h"
#include "dataset/verify/verify_plan.h"
#include "tests/dataset/small_dataset.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

/// Fisheyes, of which those of 195 degrees do not reach the corners of their square images.
const Plan& fisheye_plan() {
  static const Plan plan = [] {
    Recipe recipe = small_plan().recipe;
    recipe.base_hfov_deg.clear();
    recipe.hfov_deg = {100, 195};
    recipe.sizes = {{48, 48}};
    recipe.lens_model = "kannala_brandt";
    recipe.undistorted = false;
    recipe.lenses = 6;
    recipe.labels = {DenseLabel::depth, DenseLabel::distance, DenseLabel::rays, DenseLabel::up,
                     DenseLabel::latitude};
    REQUIRE(recipe.fault() == "");
    return make_plan(recipe, Rig{}, {{.file = "plain.glb"}},
                     [](const fs::path&) { return DrivenScene{.scene = plain_scene(6)}; });
  }();
  return plan;
}

/// The dataset of that plan, with a leaf folder whose lens does not show its frame's corners. Other lenses
/// show these, but not the whole kernels of the pixels there, and have a mask too.
struct FisheyeDataset {
  TemporaryFolder folder = {};
  fs::path root = folder.path / "data";
  fs::path masked = {};

  FisheyeDataset() {
    write_small_dataset(root, fisheye_plan());
    for (const PlannedGroup& group : fisheye_plan().groups) {
      const fs::path leaf = root / group.folder;
      if (masked.empty() && read_json(leaf / "calibration.json")["fov_true_deg"]["d"].is_null())
        masked = leaf;
    }
    REQUIRE_FALSE(masked.empty());
    REQUIRE(fs::exists(masked / "valid.png"));
  }

  std::string faults() const {
    std::string joined;
    for (const std::string& fault : verify_dataset(root).faults) joined += fault + "\n";
    return joined;
  }

  /// Changes the masked folder's label.
  template <typename Change>
  void change_label(Change change) const {
    nlohmann::ordered_json json = nlohmann::ordered_json::parse(read_file(masked / "calibration.json"));
    change(json);
    write_json(masked / "calibration.json", json);
  }
};

}  // namespace

TEST_CASE("a dataset of fisheyes says what it is and verifies and is what its plan gives") {
  const FisheyeDataset data;
  const nlohmann::json description = read_json(data.root / "dataset.json");
  CHECK(description["model"] == "kannala_brandt");
  CHECK(description["is_cps"] == false);
  CHECK_THAT(description["note"].get<std::string>(), Catch::Contains("not a CPS dataset"));
  CHECK(description["recipe"]["lens_model"] == "kannala_brandt");
  CHECK(to_text(read_recipe(data.root)) == to_text(fisheye_plan().recipe));
  const VerifySummary summary = verify_dataset(data.root);
  CHECK(summary.faults == std::vector<std::string>{});
  CHECK(summary.images == image_count(fisheye_plan()));
  CHECK(summary.dense == 5 * image_count(fisheye_plan()));
  CHECK(summary.max_roundtrip_px < 1e-9);
  CHECK_THAT(summary.brief(), !Catch::Contains("master"));
  CHECK(faults_against_plan(data.root, fisheye_plan()) == std::vector<std::string>{});
  for (const PlannedGroup& group : fisheye_plan().groups) {
    const nlohmann::json label = read_json(data.root / group.folder / "calibration.json");
    CHECK(label.contains("valid") == fs::exists(data.root / group.folder / "valid.png"));
    CHECK(label["fov_true_deg"]["h"].get<double>() ==
          Approx(fisheye_plan().sets[group.set].hfov_deg).epsilon(1e-9));
  }
}

TEST_CASE("dataset.json of Brown-Conrady lenses does not speak of families") {
  const TemporaryFolder folder;
  write_small_dataset(folder.path, small_plan());
  const nlohmann::json description = read_json(folder.path / "dataset.json");
  for (const char* key : {"model", "is_cps", "note"}) CHECK_FALSE(description.contains(key));
  CHECK_FALSE(description["recipe"].contains("lens_model"));
}

TEST_CASE("verify finds a damaged parameter or mask or image of a dataset of fisheyes") {
  const std::string label = "calibration.json: ";
  {
    const FisheyeDataset data;
    data.change_label(
        [](auto& json) { json["params"]["k1"] = json["params"]["k1"].template get<double>() + 1e-6; });
    CHECK_THAT(data.faults(), Catch::Contains(label + "fov_true_deg: contradicts model, params and K"));
    CHECK_THAT(faults_against_plan(data.root, fisheye_plan()).at(0),
               Catch::Contains("is not what the recipe gives"));
  }
  {
    const FisheyeDataset data;
    data.change_label([](auto& json) { json["K"][0][0] = 1.001 * json["K"][0][0].template get<double>(); });
    CHECK_THAT(data.faults(), Catch::Contains(label + "fov_true_deg: contradicts"));
  }
  {
    const FisheyeDataset data;
    data.change_label([](auto& json) { json["certificate"]["max_angle_deg"] = 90; });
    CHECK_THAT(data.faults(), Catch::Contains(label + "certificate: max_angle_deg contradicts"));
  }
  {
    const FisheyeDataset data;
    data.change_label([](auto& json) { json.erase("valid"); });
    CHECK_THAT(data.faults(), Catch::Contains(label + "lens is not certified"));
  }
  {
    const FisheyeDataset data;
    OIIO::ImageBuf white(OIIO::ImageSpec(48, 48, 1, OIIO::TypeDesc::UINT8));
    std::fill_n(static_cast<std::uint8_t*>(white.localpixels()), 48 * 48, std::uint8_t{255});
    write_file(data.masked / "valid.png", encode_png(white));
    CHECK_THAT(data.faults(), Catch::Contains(label + "valid: valid.png is not the mask of this lens"));
    fs::remove(data.masked / "valid.png");
    CHECK_THAT(data.faults(), Catch::Contains("valid.png"));
  }
  {
    const FisheyeDataset data;
    const std::string image = fisheye_plan().groups[fisheye_plan().views[0].groups[0]].folder + "/" +
                              image_name(fisheye_plan(), fisheye_plan().views[0]);
    fs::resize_file(data.root / image, 200);
    CHECK_THAT(data.faults(), Catch::Contains(image + ": its bytes do not match"));
  }
}

TEST_CASE("a lost mask is made again with its label") {
  const FisheyeDataset data;
  const std::string mask = read_file(data.masked / "valid.png");
  fs::remove(data.masked / "valid.png");
  for (const PlannedGroup& group : fisheye_plan().groups) write_label(data.root, fisheye_plan(), group);
  CHECK(read_file(data.masked / "valid.png") == mask);
}

TEST_CASE("readers of Brown-Conrady datasets refuse one of fisheyes in a line that names the family") {
  const FisheyeDataset data;
  const auto refusal = [](auto read) -> std::string {
    try {
      read();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  const std::string refusals[] = {refusal([&] { read_dataset(data.root); }),
                                  refusal([&] { read_export_source(data.root); }),
                                  refusal([&] { report_page(data.root, {}); }),
                                  refusal([&] { migrate_dataset(data.root, [](const std::string&) {}); })};
  for (const std::string& line : refusals)
    CHECK_THAT(line, Catch::Contains("calibration.json: model: is kannala_brandt: only datasets of "
                                     "brown_conrady lenses are read here") &&
                         !Catch::Contains("\n"));
  const Dataset any = read_dataset(data.root, LensFamilies::any);
  CHECK(any.groups.size() == fisheye_plan().groups.size());
  for (const DatasetGroup& group : any.groups) CHECK(group.camera().lens == group.model->camera.lens);
  const ContactSheetOptions options{.rows_per_set = 1, .columns = 3, .tile_width_px = 64};
  const OIIO::ImageBuf sheet = contact_sheet(any, options);
  CHECK(sheet.spec().width == 6 + 3 * (64 + 6));
}
