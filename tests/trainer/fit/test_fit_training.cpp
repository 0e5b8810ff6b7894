#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/street.h"
#include "trainer/evaluation/evaluate.h"
#include "trainer/evaluation/predict.h"
#include "trainer/model/model_card.h"
#include "trainer/onnx/export_onnx.h"
#include "trainer/training/train.h"

using namespace cps;

namespace {

TrainOptions quick_fit() {
  TrainOptions options;
  options.head = Head::brown_conrady_fit;
  options.target_space = TargetSpace::seen;
  options.orientation.measured = true;
  options.architecture = "resnet18-16";
  options.reduction.width = 80;
  options.epochs = 3;
  options.batch_size = 4;
  options.threads = 2;
  return options;
}

Dataset streets(const std::filesystem::path& root, int places) {
  return make_street_dataset(root, {.sizes = {{160, 90}, {192, 72}},
                                    .fields_of_view = 2,
                                    .lenses_per_part = 2,
                                    .train_places = places,
                                    .val_places = 1,
                                    .test_places = 1});
}

}  // namespace

TEST_CASE("a network with a fit trains; resumed it has the same weights; its card has the deviation scale") {
  const TemporaryFolder folder;
  const Dataset dataset = streets(folder.path / "data", 1);
  TrainOptions options = quick_fit();
  options.dropout = .25;
  options.ema_decay = .9;
  const TrainSummary whole = train(dataset, folder.path / "whole", options, false, {});
  CHECK(whole.is_finished);
  for (const EpochReport& epoch : whole.epochs) {
    CHECK(std::isfinite(epoch.training_loss));
    CHECK(epoch.validation_hfov_mae_deg < 90);
  }
  const auto once = [](const EpochReport&) { return false; };
  train(dataset, folder.path / "parts", options, false, once);
  train(dataset, folder.path / "parts", {}, true, {});
  const bool is_equal =
      read_file(folder.path / "whole/weights.pt") == read_file(folder.path / "parts/weights.pt");
  CHECK(is_equal);
  const ModelCard card = load_model_card(folder.path / "parts");
  CHECK(card.options == options);
  CHECK(card.deviation_scale == load_model_card(folder.path / "whole").deviation_scale);
  CHECK(card.deviation_scale != Outputs{1, 1, 1, 1, 1, 1, 1, 1});
}

TEST_CASE("what leaves a network with a fit is one-to-one and has deviations") {
  const TemporaryFolder folder;
  const Dataset dataset = streets(folder.path / "data", 1);
  TrainOptions options = quick_fit();
  options.epochs = 1;
  options.learning_rate = .2;  // far too much, so that it says wild things
  options.max_gradient = 0;
  train(dataset, folder.path / "model", options, false, {});
  const Predictor predictor(folder.path / "model");
  const Evaluation evaluation =
      evaluate(predictor, evaluation_set(dataset, Part::test), {.resamples = 0, .per_camera = true});
  CHECK(evaluation.network.folding == 0);
  CHECK(evaluation.network.without_camera == 0);
  REQUIRE(evaluation.coverage);
  CHECK(evaluation.report().find("errors within deviations") != std::string::npos);
  const nlohmann::ordered_json json = to_json(evaluation);
  CHECK(json.at("reliability").at("normal").size() == reliability_points);
  // The curve's points at one and two deviations are the coverage.
  CHECK(json.at("reliability").at("k1").at(3) == json.at("coverage").at("within_one").at("k1"));
  CHECK(json.at("reliability").at("cy").at(7) == json.at("coverage").at("within_two").at("cy"));
  for (const EvaluatedImage& image : evaluation.images) {
    REQUIRE(image.apparent_deviation);
    // Both spaces have the same H-FOV and principal point.
    for (int i : {0, 6, 7}) CHECK((*image.apparent_deviation)[i] == Approx((*image.deviation)[i]));
  }

  REQUIRE(evaluation.edges.size() == 3);
  const auto error_px = [&](int i) {
    return evaluation.images[evaluation.edges[i].image].network.reprojection_px.value();
  };
  CHECK(evaluation.edges[0].rank == "best");
  CHECK(evaluation.edges[2].rank == "worst");
  for (const EvaluatedImage& image : evaluation.images) {
    CHECK(image.network.reprojection_px.value() >= error_px(0));
    CHECK(image.network.reprojection_px.value() <= error_px(2));
  }
  for (const TrustedEdges& edges : evaluation.edges) {
    const Pinhole& camera = evaluation.images[edges.image].image.truth.pinhole;
    CHECK(edges.evidence.edges.picture == ImageSize{camera.width, camera.height});
    CHECK(edges.model.tilt.size() == edges.evidence.edges.weight.size());
  }
  const std::string page = to_html(evaluation);
  CHECK_THAT(page, Catch::Contains("id=\"reliability\"") && Catch::Contains("id=\"edges\"") &&
                       Catch::Contains("id=\"cameras\""));
  // A clip path that is named as a section clips nothing.
  std::set<std::string> ids;
  for (std::size_t at = page.find(" id=\""); at != std::string::npos; at = page.find(" id=\"", at + 1)) {
    const std::string id = page.substr(at + 5, page.find('"', at + 5) - at - 5);
    CHECK(ids.insert(id).second);
  }
  CHECK(ids.size() > 6);

  const std::filesystem::path file = dataset.root / dataset.images.front().file;
  const auto predictions = predict_images(predictor, std::span(&file, 1), {.variants = 0});
  REQUIRE(predictions.front().deviation);
  for (double deviation : *predictions.front().deviation) CHECK(deviation > 0);
  CHECK(report(predictions).find("deviation") != std::string::npos);
  CHECK(to_json(predictions)[0].at("deviation").contains("fov"));

  CHECK_THROWS_WITH(write_onnx(folder.path / "model", folder.path / "model.onnx"),
                    Catch::Contains("a fit has no ONNX form"));
}

TEST_CASE("a fit reads lenses better than the same network without it, on streets never seen", "[slow]") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path / "data", {.sizes = {{320, 180}},
                                                                     .fields_of_view = 8,
                                                                     .lenses_per_part = 3,
                                                                     .train_places = 16,
                                                                     .val_places = 4,
                                                                     .test_places = 6});
  const auto evaluated = [&](Head head) {
    TrainOptions options = quick_fit();
    options.head = head;
    options.reduction.width = 160;
    options.epochs = 15;
    options.batch_size = 16;
    train(dataset, folder.path / to_string(head), options, false, {});
    return evaluate(Predictor(folder.path / to_string(head)), evaluation_set(dataset, Part::test),
                    {.resamples = 0});
  };
  const Evaluation fit = evaluated(Head::brown_conrady_fit), direct = evaluated(Head::brown_conrady);
  CHECK(fit.network.hfov_mean_deg < .5 * fit.training_mean.hfov_mean_deg);
  CHECK(fit.network.apparent_mae[1] < .92 * direct.network.apparent_mae[1]);
  CHECK(fit.network.folding == 0);
}
