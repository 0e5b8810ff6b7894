#include <catch2/catch.hpp>
#include <cmath>

#include "files/files.h"
#include "numbers/angles.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/street.h"
#include "trainer/evaluation/evaluate.h"
#include "trainer/evaluation/predict.h"
#include "trainer/training/samples.h"
#include "trainer/training/train.h"

using namespace cps;

namespace {

Predictor briefly_trained(const Dataset& dataset, const std::filesystem::path& model) {
  TrainOptions options;
  options.reduction.width = 48;
  options.epochs = 2;
  options.batch_size = 8;
  train(dataset, model, options, false, {});
  return Predictor(model);
}

/// R² of k1 R² as eval.json's images say: R is the half diagonal of the image at distance 1.
double k1_r2_of(const nlohmann::ordered_json& evaluation) {
  std::vector<double> truths;
  double squared = 0, sum = 0, spread = 0;
  for (const auto& image : evaluation.at("images")) {
    const double aspect = image.at("height").get<double>() / image.at("width").get<double>();
    const auto apparent_k1 = [&](const nlohmann::ordered_json& outputs) {
      const double half = std::tan(outputs.at("fov").get<double>() / 2);
      return outputs.at("k1").get<double>() * half * half * (1 + aspect * aspect);
    };
    truths.push_back(apparent_k1(image.at("true")));
    squared += std::pow(apparent_k1(image.at("said")) - truths.back(), 2);
    sum += truths.back();
  }
  for (double truth : truths) spread += std::pow(truth - sum / truths.size(), 2);
  return 1 - squared / spread;
}

}  // namespace

TEST_CASE("a trained model gives the same evaluation each time, equal to that of its single predictions") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(
      folder.path / "data",
      {.sizes = {{96, 54}, {80, 64}}, .fields_of_view = 2, .lenses_per_part = 2, .train_places = 2});
  const Predictor predictor = briefly_trained(dataset, folder.path / "model");

  const Evaluation evaluation =
      evaluate(predictor, evaluation_set(dataset, Part::test), {.resamples = 50, .robustness = true});
  const std::vector<int> images = images_of(dataset, Part::test);
  CHECK(evaluation.network.images == static_cast<int>(images.size()));

  // The same errors from single predictions, and the baseline computed here.
  double hfov_deg = 0, reprojection_px = 0, baseline_deg = 0, mean_rad = 0;
  const std::vector<int> training = images_of(dataset, Part::train);
  for (int i : training)
    mean_rad += hfov_rad(dataset.groups[dataset.images[i].group].label.camera) / training.size();
  for (int i : images) {
    const std::vector<std::filesystem::path> file{dataset.root / dataset.images[i].file};
    const ImagePrediction prediction = predict_images(predictor, file).at(0);
    const double truth = hfov_rad(dataset.groups[dataset.images[i].group].label.camera);
    REQUIRE(prediction.truth);
    CHECK(hfov_rad(prediction.truth->pinhole) == Approx(truth));
    REQUIRE(prediction.reprojection_px);
    hfov_deg += degrees(std::abs(prediction.raw[0] - truth)) / images.size();
    reprojection_px += *prediction.reprojection_px / images.size();
    baseline_deg += degrees(std::abs(mean_rad - truth)) / images.size();
  }
  CHECK(evaluation.network.hfov_mean_deg == Approx(hfov_deg).epsilon(1e-4));
  CHECK(evaluation.network.reprojection_mean_px == Approx(reprojection_px).epsilon(1e-3));
  CHECK(evaluation.training_mean.hfov_mean_deg == Approx(baseline_deg).epsilon(1e-9));
  CHECK(evaluation.centre.hfov_mean_deg == Approx(baseline_deg).epsilon(1e-9));
  CHECK(evaluation.centre.raw_mae[1] > 0);

  const Evaluation again = evaluate(Predictor(folder.path / "model"), evaluation_set(dataset, Part::test),
                                    {.resamples = 50, .robustness = true});
  CHECK(to_json(again).dump() == to_json(evaluation).dump());

  // Bins of one kind hold every image once; the first row of the robustness table is the network itself.
  for (const char* kind : {"H-FOV", "size", "camera", "lens"}) {
    int members = 0;
    double sum = 0;
    for (const EvaluationBin& bin : evaluation.bins)
      if (bin.kind == kind) {
        members += bin.images;
        sum += bin.images * bin.network.hfov_mean_deg;
      }
    CHECK(members == evaluation.network.images);
    CHECK(sum / members == Approx(evaluation.network.hfov_mean_deg));
  }
  REQUIRE(evaluation.robustness.size() == 9);
  CHECK(evaluation.robustness[0].hfov_mean_deg == Approx(evaluation.network.hfov_mean_deg).epsilon(1e-6));
  CHECK(evaluation.headline.hfov_mean_deg.interval.low <= evaluation.network.hfov_mean_deg);
  CHECK(evaluation.headline.hfov_mean_deg.interval.high >= evaluation.network.hfov_mean_deg);

  // R² of k1, beside the intervals that were there before it.
  const nlohmann::ordered_json json = to_json(evaluation);
  const Estimate& k1_r2 = evaluation.headline.k1_r2;
  CHECK(k1_r2.value == Approx(k1_r2_of(json)).epsilon(1e-9));
  CHECK(k1_r2.interval.low < k1_r2.interval.high);
  CHECK(k1_r2.interval.high <= 1);
  CHECK(json.at("intervals_95").at("k1_r2").at("value") == k1_r2.value);
  CHECK(json.at("intervals_95").begin().key() == "hfov_mean_deg");
  CHECK(json.at("intervals_95").size() == 8);
  CHECK_THAT(evaluation.report(), Catch::Contains("k1 apparent, R squared"));

  const std::string page = to_html(evaluation);
  CHECK_THAT(page, Catch::Contains("<svg") && Catch::Contains("data:image/png;base64,iVBOR") &&
                       Catch::Contains("Gaussian blur, 2 px") && !Catch::Contains("<script"));
  // It says nothing of deviations and trusted edges, which only a head with a fit has.
  CHECK_THAT(page, Catch::Contains("id=\"predicted\"") && Catch::Contains("id=\"errors\"") &&
                       Catch::Contains("id=\"failures\"") && !Catch::Contains("id=\"reliability\"") &&
                       !Catch::Contains("id=\"edges\""));
  CHECK_FALSE(json.contains("reliability"));
  for (const auto& bin : json.at("bins"))
    CHECK(bin.at("intervals_95").at("hfov_mean_deg").at("value") ==
          bin.at("network").at("hfov_deg").at("mean"));

  // A picture that cannot be read is named, and refused or left out.
  const std::filesystem::path spoilt = dataset.root / dataset.images[images[0]].file;
  write_file(spoilt, std::string_view("no picture"));
  CHECK_THROWS_WITH(evaluate(predictor, evaluation_set(dataset, Part::test)),
                    Catch::StartsWith(spoilt.string()));
  const Evaluation rest =
      evaluate(predictor, evaluation_set(dataset, Part::test), {.resamples = 0, .skip_bad_images = true});
  CHECK(rest.network.images == static_cast<int>(images.size()) - 1);
  REQUIRE(rest.skipped.size() == 1);
  CHECK_THAT(rest.skipped[0], Catch::StartsWith(spoilt.string()));
}

TEST_CASE("a prediction has a spread that is the same each time, and a certified lens") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(
      folder.path / "data",
      {.sizes = {{96, 54}}, .fields_of_view = 2, .lenses_per_part = 2, .train_places = 2});
  const Predictor predictor = briefly_trained(dataset, folder.path / "model");
  const std::vector<std::filesystem::path> file{dataset.root / dataset.images[0].file};
  const ImagePrediction one = predict_images(predictor, file).at(0),
                        again = predict_images(predictor, file).at(0);
  CHECK(one.spread == again.spread);
  for (double s : one.spread) CHECK(s > 0);
  REQUIRE(one.certified);
  CHECK(is_one_to_one(one.certified->camera));
  const ImagePrediction plain = predict_images(predictor, file, {.variants = 0}).at(0);
  CHECK(plain.spread == Outputs{});
  CHECK(plain.raw == one.raw);
  CHECK_THAT(report(std::vector{one}), Catch::Contains("spread"));
  CHECK_THAT(report(std::vector{plain}), !Catch::Contains("spread"));
  CHECK(to_json(std::vector{one}).at(0).at("certified").at("kept") <= 1);
}

TEST_CASE("a folder without a model is refused in one line") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(Predictor(folder.path), Catch::StartsWith((folder.path / "model.json").string() + ": "));
}
