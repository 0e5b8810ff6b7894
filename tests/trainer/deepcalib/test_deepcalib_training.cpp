#include <catch2/catch.hpp>
#include <cmath>

#include "dataset/exchange/model_calibration.h"
#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/deepcalib/sphere_street.h"
#include "tests/trainer/street.h"
#include "trainer/evaluation/predict_spheres.h"
#include "trainer/model/model_card.h"
#include "trainer/model/train_presets.h"
#include "trainer/onnx/export_onnx.h"
#include "trainer/training/samples.h"
#include "trainer/training/train.h"

using namespace cps;

namespace {

constexpr Head deepcalib_heads[] = {Head::deepcalib_regression, Head::deepcalib_classification};

TrainOptions quick_deepcalib(Head head) {
  TrainOptions options;
  options.head = head;
  options.architecture = "resnet18-16";
  options.reduction.width = 48;
  options.size_features = false;
  options.batch_size = 8;
  options.threads = 2;
  return options;
}

/// The loss of a network that says the middle of both intervals, or all bins alike.
double untrained_loss(const Dataset& dataset, Head head) {
  if (head == Head::deepcalib_classification) return std::log(46.0) + std::log(61.0);
  double sum = 0;
  const std::vector<int> images = images_of(dataset, Part::train);
  for (int i : images) {
    const SphereTarget target = to_sphere_target(dataset.groups[dataset.images[i].group].camera(), "label");
    sum += std::log(std::cosh(target.focal - .5)) + std::log(std::cosh(target.xi - .5));
  }
  return sum / static_cast<double>(2 * images.size());
}

}  // namespace

TEST_CASE("both DeepCalib heads learn eight images by heart") {
  const TemporaryFolder folder;
  const Dataset dataset = make_sphere_dataset(folder.path / "data");
  REQUIRE(images_of(dataset, Part::train).size() == 8);
  for (const Head head : deepcalib_heads) {
    INFO(to_string(head));
    TrainOptions options = quick_deepcalib(head);
    options.epochs = 100;
    options.learning_rate = 3e-3;
    options.mirror = false;
    const TrainSummary summary = train(dataset, folder.path / to_string(head), options, false, {});
    CHECK(summary.epochs.front().training_loss == Approx(untrained_loss(dataset, head)).epsilon(1e-4));
    CHECK(summary.epochs.back().training_loss < .1 * summary.epochs.front().training_loss);
    CHECK(std::isfinite(summary.epochs.back().validation_hfov_mae_deg));
  }
}

TEST_CASE("a resumed run with a DeepCalib head gives the same weights bit for bit") {
  const TemporaryFolder folder;
  const Dataset dataset = make_sphere_dataset(folder.path / "data");
  for (const Head head : deepcalib_heads) {
    INFO(to_string(head));
    TrainOptions options = quick_deepcalib(head);
    options.epochs = 3;
    options.batch_size = 4;
    options.dropout = .25;
    options.augmentation.probability = .3;
    options.ema_decay = .9;
    const std::filesystem::path whole = folder.path / (to_string(head) + "_whole"),
                                parts = folder.path / (to_string(head) + "_parts");
    const TrainSummary at_once = train(dataset, whole, options, false, {});
    const auto once = [](const EpochReport&) { return false; };
    CHECK_FALSE(train(dataset, parts, options, false, once).is_finished);
    const TrainSummary resumed = train(dataset, parts, {}, true, {});
    CHECK(resumed.is_finished);
    CHECK(read_file(whole / "weights.pt") == read_file(parts / "weights.pt"));
    REQUIRE(resumed.epochs.size() == 3);
    for (int e = 0; e < 3; ++e) CHECK(resumed.epochs[e].validation_loss == at_once.epochs[e].validation_loss);

    const ModelCard card = load_model_card(parts);
    CHECK(card.options == options);
    const SphereStatistics expected = [&] {
      std::vector<SphereTarget> targets;
      for (int i : images_of(dataset, Part::train))
        targets.push_back(to_sphere_target(dataset.groups[dataset.images[i].group].camera(), "label"));
      return sphere_statistics(targets);
    }();
    CHECK(card.spheres.mean == expected.mean);
    CHECK(card.spheres.deviation == expected.deviation);
  }
}

TEST_CASE("networks and datasets of different lens families are kept apart in one line") {
  const TemporaryFolder folder;
  const Dataset spheres = make_sphere_dataset(folder.path / "spheres");
  const Dataset plane = make_street_dataset(folder.path / "plane", {.sizes = {{48, 32}},
                                                                    .fields_of_view = 2,
                                                                    .lenses_per_part = 2,
                                                                    .train_places = 1,
                                                                    .val_places = 1,
                                                                    .test_places = 1});
  TrainOptions brown_conrady = quick_deepcalib(Head::brown_conrady);
  brown_conrady.epochs = 1;
  const auto model = folder.path / "model";
  CHECK_THROWS_WITH(train(spheres, model, brown_conrady, false, {}),
                    Catch::StartsWith((folder.path / "spheres" / spheres.groups[0].folder).string()) &&
                        Catch::Contains("model: is unified_spherical") &&
                        Catch::Contains("deepcalib-regression") && !Catch::Contains("\n"));
  for (const Head head : deepcalib_heads)
    CHECK_THROWS_WITH(train(plane, model, quick_deepcalib(head), false, {}),
                      Catch::StartsWith((folder.path / "plane").string()) &&
                          Catch::Contains("brown_conrady") &&
                          Catch::Contains("lens_model = unified_spherical") && !Catch::Contains("\n"));
  CHECK_FALSE(std::filesystem::exists(model));
  CHECK_THROWS_WITH(read_dataset(folder.path / "spheres"), Catch::Contains("model: is unified_spherical"));

  TrainOptions sphere = quick_deepcalib(Head::deepcalib_regression);
  sphere.epochs = 1;
  train(spheres, folder.path / "sphere", sphere, false, {});
  train(plane, folder.path / "flat", brown_conrady, false, {});
  CHECK_THROWS_WITH(Predictor(folder.path / "sphere")({}), Catch::Contains("no Brown-Conrady lens"));
  CHECK_THROWS_WITH(Predictor(folder.path / "flat").spheres({}),
                    Catch::Contains("no unified spherical lens"));
  CHECK_THROWS_WITH(write_onnx(folder.path / "sphere", folder.path / "sphere.onnx"),
                    Catch::Contains("only networks of Brown-Conrady lenses can be exported"));
  brown_conrady.teacher = (folder.path / "sphere").string();
  CHECK_THROWS_WITH(train(plane, folder.path / "pupil", brown_conrady, false, {}),
                    Catch::Contains("lenses of another family"));
}

TEST_CASE("options that a DeepCalib head has no use for are refused by name") {
  const auto refusal = [](auto change) {
    TrainOptions options = train_preset("deepcalib-regression");
    change(options);
    return options.fault();
  };
  CHECK(refusal([](TrainOptions&) {}) == "");
  CHECK_THAT(refusal([](TrainOptions& o) { o.loss = Loss::huber; }), Catch::StartsWith("loss: "));
  CHECK_THAT(refusal([](TrainOptions& o) { o.outputs = {"fov"}; }), Catch::StartsWith("outputs: "));
  CHECK_THAT(refusal([](TrainOptions& o) { o.online_lenses = true; }), Catch::StartsWith("online-lenses: "));
  CHECK_THAT(refusal([](TrainOptions& o) { o.teacher = "m"; }), Catch::StartsWith("teacher: "));
  // The two presets differ in the head alone, and a card without a head is Brown–Conrady's.
  TrainOptions regression = train_preset("deepcalib-regression");
  regression.head = Head::deepcalib_classification;
  CHECK(regression == train_preset("deepcalib-classification"));
  CHECK_FALSE(to_json(TrainOptions{}).contains("head"));
  CHECK(to_json(regression).at("head") == "deepcalib_classification");
  CHECK_THROWS_WITH(head_from_string("inception"), Catch::Contains("deepcalib_regression"));
}

TEST_CASE("a prediction is a calibration file of a unified spherical camera with errors in ray space") {
  const TemporaryFolder folder;
  const Dataset dataset = make_sphere_dataset(folder.path / "data");
  TrainOptions options = quick_deepcalib(Head::deepcalib_classification);
  options.epochs = 1;
  train(dataset, folder.path / "model", options, false, {});
  const Predictor predictor(folder.path / "model");
  const DatasetImage& image = dataset.images.front();
  const std::vector<std::filesystem::path> files{dataset.root / image.file};
  const std::vector<SpherePrediction> predictions = predict_spheres(predictor, files);
  REQUIRE(predictions.size() == 1);
  const SpherePrediction& p = predictions[0];
  REQUIRE(p.truth);
  CHECK(p.truth->lens == dataset.groups[image.group].camera().lens);
  CHECK(p.seen_hfov_rad > 0);
  const std::filesystem::path file = folder.path / "calibration.yml";
  write_model_calibration(file, CalibrationFormat::opencv_yaml, std::vector{p.camera});
  const ModelCamera read = read_model_camera(file, "");
  CHECK(read.lens == p.camera.lens);
  CHECK(read.pinhole == p.camera.pinhole);
  CHECK_THAT(report(predictions), Catch::Contains("unified_spherical") && Catch::Contains("true lens"));
  CHECK(to_json(predictions).at(0).at("prediction").at("model") == "unified_spherical");
}
