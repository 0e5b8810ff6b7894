#include <catch2/catch.hpp>

#include "tests/temporary_folder.h"
#include "tests/trainer/street.h"
#include "trainer/evaluation/evaluate.h"
#include "trainer/training/samples.h"
#include "trainer/training/train.h"

using namespace cps;

TEST_CASE("eight images are learned by heart") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path / "data", {.sizes = {{96, 54}},
                                                                     .fields_of_view = 4,
                                                                     .lenses_per_part = 2,
                                                                     .train_places = 1,
                                                                     .val_places = 1,
                                                                     .test_places = 1});
  REQUIRE(images_of(dataset, Part::train).size() == 8);
  TrainOptions options;
  options.architecture = "resnet18-16";  // its state, which every epoch writes, is small
  options.reduction.width = 96;
  options.epochs = 80;
  options.batch_size = 8;
  options.mirror = false;
  const TrainSummary summary = train(dataset, folder.path / "model", options, false, {});
  CHECK(summary.epochs.front().training_loss ==
        Approx(1).epsilon(.05));  // the error of predicting the mean, by construction
  CHECK(summary.epochs.back().training_loss < .01);
}

TEST_CASE("a network learns H-FOV on streets that it has never seen", "[slow]") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path / "data", {.sizes = {{160, 90}},
                                                                     .fields_of_view = 8,
                                                                     .lenses_per_part = 3,
                                                                     .train_places = 16,
                                                                     .val_places = 4,
                                                                     .test_places = 6});
  TrainOptions options;
  options.reduction.width = 160;
  options.epochs = 15;
  train(dataset, folder.path / "model", options, false, {});
  const Evaluation evaluation =
      evaluate(Predictor(folder.path / "model"), evaluation_set(dataset, Part::test));
  CHECK(evaluation.network.hfov_mean_deg < .5 * evaluation.training_mean.hfov_mean_deg);
  CHECK(evaluation.network.reprojection_mean_px < .6 * evaluation.training_mean.reprojection_mean_px);
}
