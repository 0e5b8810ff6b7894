#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <set>
#include <sstream>

#include "files/files.h"
#include "trainer/model/train_options.h"
#include "trainer/model/train_presets.h"

using namespace cps;

TEST_CASE("the learning rate rises, holds and steps down") {
  TrainOptions o;
  o.learning_rate = 1e-3;
  o.warm_up_epochs = 2;
  o.milestones = {.5, .75};
  o.decay = .1;
  CHECK(learning_rate_at(o, .5, 20) == Approx(.25e-3));
  CHECK(learning_rate_at(o, 2, 20) == Approx(1e-3));
  CHECK(learning_rate_at(o, 9.99, 20) == Approx(1e-3));
  CHECK(learning_rate_at(o, 10, 20) == Approx(1e-4));
  CHECK(learning_rate_at(o, 15, 20) == Approx(1e-5));
  CHECK(learning_rate_at(o, 5, 10) == Approx(1e-4));  // by fraction of the plan
}

TEST_CASE("options survive JSON, and presets are valid") {
  for (const TrainPreset& preset : train_presets()) {
    CHECK(preset.options.fault() == "");
    CHECK(train_options_from_json(nlohmann::json::parse(to_json(preset.options).dump())) == preset.options);
  }
  CHECK_THROWS_WITH(train_preset("none"), Catch::Contains("demo"));
}

TEST_CASE(
    "a model from before an option existed gets its default; one that lacks an older option is damaged") {
  nlohmann::json json = nlohmann::json::parse(to_json(TrainOptions{}).dump());
  json.erase("teacher");
  json.erase("online_lenses");
  json.erase("precision");
  REQUIRE_FALSE(json.contains("places_share"));
  CHECK(train_options_from_json(json) == TrainOptions{});
  json.erase("architecture");
  CHECK_THROWS_AS(train_options_from_json(json), nlohmann::json::exception);
}

TEST_CASE("a precision is a word in JSON and other words are refused") {
  TrainOptions options;
  options.precision = Precision::bfloat16;
  nlohmann::json json = nlohmann::json::parse(to_json(options).dump());
  CHECK(json.at("precision") == "bfloat16");
  CHECK(train_options_from_json(json) == options);
  json["precision"] = "float64";
  CHECK_THROWS_WITH(train_options_from_json(json),
                    "precision 'float64': unknown: use auto, float32 or bfloat16");
  // Presets from before the option keep the weights that they had.
  for (const TrainPreset& preset : train_presets())
    CHECK((preset.options.precision == Precision::float32) ==
          (preset.name != "reference" && !preset.name.starts_with("deepcalib-")));
}

TEST_CASE("a fit says what it needs, and is a word in JSON") {
  TrainOptions options;
  options.head = Head::brown_conrady_fit;
  CHECK_THAT(options.fault(), Catch::StartsWith("orientation: "));
  options.orientation.measured = true;
  CHECK_THAT(options.fault(), Catch::StartsWith("targets: "));
  options.target_space = TargetSpace::seen;
  CHECK(options.fault() == "");
  CHECK(to_json(options).at("head") == "brown_conrady_fit");
  CHECK(train_options_from_json(nlohmann::json::parse(to_json(options).dump())) == options);

  TrainOptions other = options;
  other.outputs = {"fov", "k1"};
  CHECK_THAT(other.fault(), Catch::StartsWith("outputs: "));
  other = options;
  other.architecture = "resnet34-nopool";
  CHECK_THAT(other.fault(), Catch::StartsWith("arch "));
  other = options;
  other.loss = Loss::reprojection;
  CHECK_THAT(other.fault(), Catch::StartsWith("loss: "));
}

TEST_CASE("a share of the places is in JSON where it is not 1 and lies above 0 and at most at 1") {
  TrainOptions options;
  options.places_share = .25;
  const nlohmann::json json = nlohmann::json::parse(to_json(options).dump());
  CHECK(json.at("places_share") == .25);
  CHECK(train_options_from_json(json) == options);
  CHECK(options.fault() == "");
  for (double share : {0., -.5, 1.0001, std::numeric_limits<double>::quiet_NaN()}) {
    options.places_share = share;
    CHECK_THAT(options.fault(), Catch::StartsWith("places-share"));
  }
}

TEST_CASE("the thesis' presets are those of the table in docs/models.md") {
  std::istringstream page(read_file(CPS_SOURCE "/docs/models.md"));
  int rows = 0;
  for (std::string line; std::getline(page, line);) {
    if (!line.starts_with("| `cps-v0.")) continue;
    ++rows;
    // | `name` | recipe `data` | learns | …
    std::vector<std::string> cells;
    std::istringstream row(line.substr(1));
    for (std::string cell; std::getline(row, cell, '|');) {
      std::erase(cell, '`');
      cells.push_back(cell.substr(1, cell.size() - 2));
    }
    INFO(line);
    const auto preset = std::ranges::find(train_presets(), cells[0], &TrainPreset::name);
    REQUIRE(preset != train_presets().end());
    CHECK(preset->purpose.starts_with(cells[1].substr(cells[1].find("cps-")) + " data"));
    std::string learned;
    for (const std::string& output : preset->options.outputs)
      learned += (learned.empty() ? "" : ", ") + output;
    CHECK((preset->options.outputs.size() == 8 ? "all eight" : learned) == cells[2]);
  }
  CHECK(rows == 7);
}

TEST_CASE("a thesis preset differs from the one before it by what is named, and by nothing else") {
  const auto changed = [](const char* name, const char* before) {
    const nlohmann::ordered_json now = to_json(train_preset(name)), then = to_json(train_preset(before));
    std::set<std::string> keys;
    for (const auto& [key, value] : now.items())
      if (value != then.at(key)) keys.insert(key);
    return keys;
  };
  using Keys = std::set<std::string>;
  CHECK(changed("cps-v0.2", "cps-v0.1") == Keys{});
  CHECK(changed("cps-v0.3", "cps-v0.2") == Keys{"outputs"});
  CHECK(changed("cps-v0.4", "cps-v0.3") == Keys{"outputs"});
  CHECK(changed("cps-v0.5", "cps-v0.4") == Keys{"outputs"});
  CHECK(changed("cps-v0.6", "cps-v0.5") == Keys{});
  CHECK(changed("cps-v0.7", "cps-v0.6") == Keys{"size_features", "milestones"});
  // A quarter of the published images, and ×.1 at 60 % and 85 % of the epochs.
  const TrainOptions& last = train_preset("cps-v0.7");
  CHECK(reduced_size({1920, 1080}, last.reduction) == ImageSize{480, 270});
  CHECK(reduced_size({1392, 512}, last.reduction) == ImageSize{348, 128});
  const double rate = learning_rate_at(last, 1, 100);
  CHECK(learning_rate_at(last, 59.9, 100) == rate);
  CHECK(learning_rate_at(last, 60.1, 100) == Approx(.1 * rate));
  CHECK(learning_rate_at(last, 85.1, 100) == Approx(.01 * rate));
}

TEST_CASE("absurd options are refused by name") {
  const auto refusal = [](auto change) {
    TrainOptions options;
    change(options);
    return options.fault();
  };
  CHECK_THAT(refusal([](TrainOptions& o) { o.architecture = "resnet9"; }), Catch::Contains("resnet18"));
  CHECK_THAT(refusal([](TrainOptions& o) { o.epochs = 0; }), Catch::StartsWith("epochs"));
  CHECK_THAT(refusal([](TrainOptions& o) { o.batch_size = 1; }), Catch::StartsWith("batch"));
  CHECK_THAT(refusal([](TrainOptions& o) { o.learning_rate = -1; }), Catch::StartsWith("lr"));
  CHECK_THAT(refusal([](TrainOptions& o) { o.reduction.width = 3; }), Catch::StartsWith("width"));
  CHECK_THAT(refusal([](TrainOptions& o) { o.outputs = {"hfov"}; }), Catch::StartsWith("outputs: 'hfov'"));
  CHECK_THAT(refusal([](TrainOptions& o) {
               o.outputs = {"fov"};
               o.loss = Loss::reprojection;
             }),
             Catch::StartsWith("loss"));
  CHECK_THAT(refusal([](TrainOptions& o) { o.ema_decay = 1; }), Catch::StartsWith("ema"));
  CHECK_THAT(refusal([](TrainOptions& o) { o.augmentation.probability = 2; }), Catch::StartsWith("augment"));
  CHECK_THAT(refusal([](TrainOptions& o) { o.teacher_weight = 1.5; }), Catch::StartsWith("teacher-weight"));
  CHECK_THAT(refusal([](TrainOptions& o) { o.orientation.max_width = 8; }),
             Catch::StartsWith("orientation-width"));
  CHECK_THAT(refusal([](TrainOptions& o) { o.online_zoom = .5; }), Catch::StartsWith("online-zoom"));
  CHECK_THROWS_WITH(loss_from_string("l1"), Catch::Contains("huber"));
  CHECK_THAT(refusal([](TrainOptions& o) { o.milestones = {.5, 1.5}; }), Catch::StartsWith("milestones"));
}
