#include <catch2/catch.hpp>

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
  std::string why;
  for (const TrainPreset& preset : train_presets()) {
    CHECK(preset.options.is_valid(&why));
    CHECK(train_options_from_json(nlohmann::json::parse(to_json(preset.options).dump())) == preset.options);
  }
  CHECK_THROWS_WITH(train_preset("none"), Catch::Contains("demo"));
}

TEST_CASE("a model from before an option existed has its default; without an older one it is damaged") {
  nlohmann::json json = nlohmann::json::parse(to_json(TrainOptions{}).dump());
  json.erase("teacher");
  json.erase("online_lenses");
  CHECK(train_options_from_json(json) == TrainOptions{});
  json.erase("architecture");
  CHECK_THROWS_AS(train_options_from_json(json), nlohmann::json::exception);
}

TEST_CASE("the thesis' presets say what docs/models.md says") {
  for (const char* name :
       {"cps-v0.1", "cps-v0.2", "cps-v0.3", "cps-v0.4", "cps-v0.5", "cps-v0.6", "cps-v0.7"}) {
    const TrainOptions& o = train_preset(name);
    CHECK(o.architecture == "resnet50");
    CHECK(o.reduction.factor == 4);
    CHECK(reduced_size({1920, 1080}, o.reduction) == ImageSize{480, 270});
    CHECK(reduced_size({1392, 512}, o.reduction) == ImageSize{348, 128});
    CHECK(o.epochs == 50);
    CHECK(o.loss == Loss::mse);
    CHECK(o.target_space == TargetSpace::raw);
    CHECK(o.size_features == (std::string(name) == "cps-v0.7"));
  }
  CHECK(train_preset("cps-v0.1").outputs == std::vector<std::string>{"fov", "k1"});
  CHECK(train_preset("cps-v0.5").outputs.size() == 8);
}

TEST_CASE("absurd options are refused by name") {
  const auto refusal = [](auto change) {
    TrainOptions options;
    change(options);
    std::string why;
    CHECK_FALSE(options.is_valid(&why));
    return why;
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
  CHECK_THAT(refusal([](TrainOptions& o) { o.online_zoom = .5; }), Catch::StartsWith("online-zoom"));
  CHECK_THROWS_WITH(loss_from_string("l1"), Catch::Contains("huber"));
  CHECK_THAT(refusal([](TrainOptions& o) { o.milestones = {.5, 1.5}; }), Catch::StartsWith("milestones"));
}
