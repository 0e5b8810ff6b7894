#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/street.h"
#include "trainer/model/model_card.h"
#include "trainer/training/train.h"

using namespace cps;

namespace {

StreetDatasetOptions small() {
  return {.sizes = {{96, 54}, {80, 64}},
          .fields_of_view = 2,
          .lenses_per_part = 2,
          .train_places = 2,
          .val_places = 1,
          .test_places = 1};
}

TrainOptions four_epochs() {
  TrainOptions options;
  options.reduction.width = 48;
  options.epochs = 4;
  options.batch_size = 4;
  options.dropout = .25;  // its noise must be repeated, too
  options.augmentation.probability = .3;
  options.ema_decay = .9;
  options.threads = 2;
  return options;
}

}  // namespace

TEST_CASE("a resumed run gives the same weights, bit for bit") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path / "data", small());
  const TrainOptions options = four_epochs();
  const TrainSummary whole = train(dataset, folder.path / "whole", options, false, {});
  CHECK(whole.is_finished);

  const auto until = [](int epoch) {
    return [epoch](const EpochReport& report) { return report.epoch < epoch; };
  };
  CHECK_FALSE(train(dataset, folder.path / "parts", options, false, until(1)).is_finished);
  CHECK_FALSE(train(dataset, folder.path / "parts", {}, true, until(3)).is_finished);
  const TrainSummary parts = train(dataset, folder.path / "parts", {}, true, {});
  CHECK(parts.is_finished);

  CHECK(read_file(folder.path / "whole/weights.pt") == read_file(folder.path / "parts/weights.pt"));
  REQUIRE(parts.epochs.size() == 4);
  for (int e = 0; e < 4; ++e) {
    CHECK(parts.epochs[e].training_loss == whole.epochs[e].training_loss);
    CHECK(parts.epochs[e].validation_loss == whole.epochs[e].validation_loss);
    CHECK(parts.epochs[e].learning_rate == whole.epochs[e].learning_rate);
  }

  CHECK(read_file(folder.path / "whole/history.csv").substr(0, 5) == "epoch");
  CHECK(read_file(folder.path / "whole/history.svg").find("<svg") != std::string::npos);

  // A finished run stays as it is.
  const std::string state = read_file(folder.path / "whole/state.pt");
  train(dataset, folder.path / "whole", {}, true, {});
  CHECK(read_file(folder.path / "whole/state.pt") == state);
}

TEST_CASE("a run in bfloat16 resumes bit for bit in the precision that it recorded") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path / "data", small());
  TrainOptions options = four_epochs();
  options.architecture = "resnet18-16";
  options.epochs = 3;
  options.precision = Precision::bfloat16;
  const TrainSummary whole = train(dataset, folder.path / "whole", options, false, {});
  CHECK_THAT(whole.brief_report(), Catch::Contains("precision bfloat16"));

  const auto once = [](const EpochReport&) { return false; };
  train(dataset, folder.path / "parts", options, false, once);
  CHECK(load_model_card(folder.path / "parts").options.precision == Precision::bfloat16);
  const TrainSummary parts = train(dataset, folder.path / "parts", {}, true, {});  // {} asks for float32
  CHECK(parts.is_finished);
  CHECK(parts.precision == Precision::bfloat16);
  CHECK(read_file(folder.path / "whole/weights.pt") == read_file(folder.path / "parts/weights.pt"));

  // It is another training than that in float32, from the same weights.
  options.precision = Precision::float32;
  const TrainSummary exact = train(dataset, folder.path / "exact", options, false, {});
  CHECK(exact.epochs[0].training_loss != whole.epochs[0].training_loss);
  CHECK(exact.epochs[0].training_loss == Approx(whole.epochs[0].training_loss).epsilon(.05));
  CHECK_THAT(exact.brief_report(), Catch::Contains("precision float32"));
}

TEST_CASE("the precision auto is recorded as what it became and a state of another is refused") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path / "data", small());
  TrainOptions options = four_epochs();
  options.architecture = "resnet10-32";
  options.epochs = 2;
  options.precision = Precision::automatic;
  const auto once = [](const EpochReport&) { return false; };
  const TrainSummary summary = train(dataset, folder.path / "model", options, false, once);
  ModelCard card = load_model_card(folder.path / "model");
  CHECK(card.options.precision == summary.precision);
  const Precision expected = processor_computes_bfloat16() ? Precision::bfloat16 : Precision::float32;
  CHECK(summary.precision == expected);

  card.options.precision = expected == Precision::float32 ? Precision::bfloat16 : Precision::float32;
  save_model_card(card, folder.path / "model");
  CHECK_THROWS_WITH(train(dataset, folder.path / "model", {}, true, {}),
                    Catch::Contains("state.pt: precision: the training used " + to_string(expected)) &&
                        Catch::Contains("model.json says " + to_string(card.options.precision)) &&
                        !Catch::Contains("\n"));
}

TEST_CASE("a model is neither overwritten nor resumed with another dataset") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path / "data", small());
  TrainOptions options = four_epochs();
  options.epochs = 1;
  train(dataset, folder.path / "model", options, false, {});
  CHECK_THROWS_WITH(train(dataset, folder.path / "model", options, false, {}), Catch::Contains("--resume"));

  Dataset other = dataset;
  other.groups[0].label.distortion.k1 += 1e-9;
  CHECK_THROWS_WITH(train(other, folder.path / "model", {}, true, {}), Catch::Contains("same dataset"));
  CHECK_THROWS_WITH(train(dataset, folder.path / "none", {}, true, {}), Catch::Contains("model.json"));

  write_file(folder.path / "model/state.pt", std::string_view("cut short"));
  CHECK_THROWS_WITH(train(dataset, folder.path / "model", {}, true, {}), Catch::Contains("state.pt"));
}

TEST_CASE("a budget of minutes cuts the planned epochs, never below one") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path / "data", small());
  TrainOptions options = four_epochs();
  options.epochs = 1000;
  options.minutes = 1e-6;
  const TrainSummary summary = train(dataset, folder.path / "model", options, false, {});
  CHECK(summary.epochs.size() == 1);
  CHECK(summary.epochs[0].planned_epochs == 1);
  CHECK(summary.is_finished);
}

TEST_CASE("every loss trains, and a run that stops improving is ended early") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path / "data", small());
  for (Loss loss : {Loss::huber, Loss::reprojection}) {
    TrainOptions options = four_epochs();
    options.loss = loss;
    options.epochs = 8;
    options.augmentation.probability = 0;
    const TrainSummary summary = train(dataset, folder.path / to_string(loss), options, false, {});
    CHECK(summary.epochs.back().training_loss < summary.epochs.front().training_loss);
    CHECK(std::isfinite(summary.epochs.back().validation_loss));
  }
  TrainOptions options = four_epochs();
  options.epochs = 50;
  options.learning_rate = 1e-12;  // validation stays where it is
  options.ema_decay = 0;
  options.patience = 2;
  const TrainSummary stopped = train(dataset, folder.path / "patience", options, false, {});
  CHECK(stopped.is_finished);
  CHECK(stopped.epochs.size() < 50);
  CHECK(static_cast<int>(stopped.epochs.size()) == stopped.best.epoch + 2);
  CHECK(train(dataset, folder.path / "patience", {}, true, {}).epochs.size() == stopped.epochs.size());
}

TEST_CASE("a part without images is refused") {
  const TemporaryFolder folder;
  StreetDatasetOptions options = small();
  options.val_places = 0;
  const Dataset dataset = make_street_dataset(folder.path / "data", options);
  CHECK_THROWS_WITH(train(dataset, folder.path / "model", four_epochs(), false, {}),
                    Catch::Contains("val.txt"));
  CHECK_FALSE(std::filesystem::exists(folder.path / "model/model.json"));
}
