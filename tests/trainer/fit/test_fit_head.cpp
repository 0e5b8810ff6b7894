#include <torch/types.h>

#include <Eigen/LU>
#include <catch2/catch.hpp>
#include <cmath>

#include "random/counter_hash.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/fit/evidence.h"
#include "tests/trainer/images/orientation/drawings.h"
#include "tests/trainer/street.h"
#include "trainer/calibration/reprojection.h"
#include "trainer/fit/fit_head.h"
#include "trainer/images/network_image.h"
#include "trainer/model/predictor.h"
#include "trainer/network/tensor_file.h"
#include "trainer/training/train.h"

using namespace cps;
using torch::Tensor;

namespace {

constexpr ImageSize shape{348, 128};

ModelCard fit_card() {
  ModelCard card;
  card.options.head = Head::brown_conrady_fit;
  card.options.target_space = TargetSpace::seen;
  card.options.orientation.measured = true;
  const LensPrior prior = wide_prior(shape);
  for (int i = 0; i < output_count; ++i) {
    card.targets.mean[i] = prior.mean[i];
    card.targets.deviation[i] = 1 / std::sqrt(prior.precision(i, i));
  }
  card.correlation(1, 2) = card.correlation(2, 1) = -.7;  // as those of k1 and k2 of drawn lenses
  return card;
}
/// A wall through a lens, and the same flipped: two images of a batch.
struct Walls {
  NetworkImage image;
  std::vector<BatchImage> batch;

  Walls() {
    const Outputs outputs{1.3, -.15, .01, 0, 0, 0, .51, .49};
    const GrayImage wall = wall_grid(*to_camera(outputs, TargetSpace::seen, shape.width, shape.height));
    image = network_image(wall, {.width = 174}, {.measured = true});
    batch = {batch_image(image, shape), batch_image(image, shape, true)};
  }
};

NetworkOutput random_output(const std::vector<BatchImage>& images, double log_weight) {
  torch::manual_seed(4);
  const ImageSize grid = weight_grid(images.front().orientation.grid);
  const long n = static_cast<long>(images.size());
  return {torch::randn({n, 2 * output_count}) * .4f,
          torch::randn({n, edge_families, grid.height, grid.width}) * .3f + log_weight};
}

}  // namespace

TEST_CASE("rows of a head with a fit hold what fit_lens finds, standardised") {
  const Walls walls;
  const ModelCard card = fit_card();
  const NetworkOutput output = random_output(walls.batch, 2);
  const Tensor rows = head_rows(output, walls.batch, card);
  REQUIRE(rows.sizes() == torch::IntArrayRef({2, row_width(card.options.head)}));
  const std::vector<FrameEvidence> frames = frame_evidence(output, walls.batch, card);
  for (int n : {0, 1}) {
    const LensFit fit = fit_lens(frames[n], 30);
    const FitMatrix covariance = fit.information.inverse();
    const std::span<const float> row(rows.data_ptr<float>() + n * rows.size(1), rows.size(1));
    const LensPosterior posterior = posterior_of(row, card);
    for (int i = 0; i < output_count; ++i) {
      const double deviation = std::sqrt(covariance(i, i));
      CHECK(posterior.mean[i] == Approx(fit.parameters[i]).margin(.02 * deviation));
      CHECK(posterior.deviation()[i] == Approx(deviation).epsilon(.02));
      for (int k = 0; k < output_count; ++k)
        CHECK(posterior.covariance(i, k) ==
              Approx(covariance(i, k)).margin(.03 * deviation * std::sqrt(covariance(k, k))));
    }
  }
}

TEST_CASE("weightless edges leave the network's own numbers") {
  const Walls walls;
  ModelCard card = fit_card();
  card.deviation_scale[1] = 3;
  const NetworkOutput output = random_output(walls.batch, -40);
  const Tensor rows = head_rows(output, walls.batch, card);
  for (int i = 0; i < output_count; ++i) {
    const float said = output.numbers[0][i].item<float>(),
                log_variance = output.numbers[0][8 + i].item<float>();
    CHECK(rows[0][i].item<float>() == Approx(said).margin(.02));
    CHECK(rows[0][output_count + 9 * i].item<float>() == Approx(std::exp(log_variance)).epsilon(.05));
  }
  // The training targets' correlation is that of the prior.
  const auto covariance = [&](int i, int k) { return rows[0][output_count + 8 * i + k].item<double>(); };
  CHECK(covariance(1, 2) == Approx(-.7 * std::sqrt(covariance(1, 1) * covariance(2, 2))).epsilon(.05));
  const LensPosterior posterior =
      posterior_of({rows.data_ptr<float>(), static_cast<std::size_t>(rows.size(1))}, card);
  CHECK(posterior.deviation()[1] ==
        Approx(3 * card.targets.deviation[1] * std::sqrt(rows[0][output_count + 9].item<float>())));
}

TEST_CASE("gradients of the rows are the differences of the fits") {
  const Walls walls;
  const ModelCard card = fit_card();
  NetworkOutput output = random_output(walls.batch, 1);
  const Tensor mix = torch::linspace(-1, 1, output_count);
  const auto value = [&](const NetworkOutput& of) {
    return (head_rows(of, walls.batch, card).narrow(1, 0, output_count) * mix).sum();
  };
  output.numbers.requires_grad_();
  output.edge_weights.requires_grad_();
  value(output).backward();

  const auto difference = [&](Tensor NetworkOutput::*of, const Tensor& direction) {
    constexpr float step = .02f;
    const torch::NoGradGuard no_gradients;
    NetworkOutput low{output.numbers.detach().clone(), output.edge_weights.detach().clone()},
        high{low.numbers.clone(), low.edge_weights.clone()};
    (low.*of).sub_(direction * step);
    (high.*of).add_(direction * step);
    return (value(high) - value(low)).item<double>() / (2 * step);
  };
  for (Tensor NetworkOutput::*of : {&NetworkOutput::numbers, &NetworkOutput::edge_weights}) {
    // Along the gradient itself, so that what the fixed slopes leave out is small beside it.
    const Tensor gradient = (output.*of).grad(), direction = gradient / gradient.abs().max();
    const double along = (gradient * direction).sum().item<double>();
    CHECK(along == Approx(difference(of, direction)).epsilon(.4));
  }
}

TEST_CASE("the likelihood is that of normal numbers") {
  Tensor rows = torch::zeros({1, row_width(Head::brown_conrady_fit)});
  for (int i = 0; i < output_count; ++i) rows[0][output_count + 9 * i] = 4;
  const Tensor truth = torch::full({1, output_count}, 3.f);
  CHECK(likelihood_loss(rows, truth).item<double>() == Approx(.5 * (9 / 4. + std::log(4))));
}

TEST_CASE("only lenses that fold in the true frame are penalised") {
  const ModelCard card = fit_card();
  const auto penalty = [&](double k1) {
    Outputs outputs = card.targets.mean;
    outputs[1] = k1;
    Tensor rows = torch::zeros({1, row_width(Head::brown_conrady_fit)});
    const Outputs standard = standardise(outputs, card.targets);
    for (int i = 0; i < output_count; ++i) rows[0][i] = standard[i];
    const std::vector<Outputs> truth{card.targets.mean};
    return folding_penalty(rows, truth, card.targets).item<double>();
  };
  CHECK(penalty(-.1) == 0);
  CHECK(penalty(.3) == 0);
  CHECK(penalty(-.5) > 0);
  CHECK(penalty(-.8) > penalty(-.5));
}

TEST_CASE("the deviation scale holds the errors that it was found on") {
  constexpr int images = 400;
  const ModelCard card = fit_card();
  Tensor rows = torch::zeros({images, row_width(Head::brown_conrady_fit)});
  std::vector<Outputs> truth;
  for (int n = 0; n < images; ++n) {
    Outputs standard;
    for (int i = 0; i < output_count; ++i) {
      rows[n][output_count + 9 * i] = .25;  // says .5
      standard[i] = random_normal(make_stream(n, "error"), i) * (i + 1) * .25;
    }
    truth.push_back(unstandardise(standard, card.targets));
  }
  const Outputs scale = deviation_scale(rows, truth, card.targets);
  // The share within the deviation has a standard error of 2.3 % at 400 images, which is 5 % of a deviation.
  for (int i = 0; i < output_count; ++i) CHECK(scale[i] == Approx((i + 1) * .5).epsilon(.17));
  CHECK(deviation_scale(rows, {}, card.targets)[0] == 1);
}

TEST_CASE("a lens that folds is pulled before it leaves the predictor") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(
      folder.path / "data",
      {.fields_of_view = 1, .lenses_per_part = 2, .train_places = 2, .val_places = 1, .test_places = 1});
  TrainOptions options = fit_card().options;
  options.architecture = "resnet18-16";
  options.reduction.width = 80;
  options.epochs = 1;
  options.batch_size = 2;
  train(dataset, folder.path / "model", options, false, {});
  // Now the network says, and is sure, that k1 is far below what any training lens has.
  NamedTensors weights = load_tensors(folder.path / "model/weights.pt");
  weights.at("fc.bias")[1] = -30;
  weights.at("fc.bias")[output_count + 1] = -9;
  save_tensors(weights, folder.path / "model/weights.pt");

  const Predictor predictor(folder.path / "model");
  const NetworkImage image = network_image(read_gray_image(dataset.root / dataset.images.front().file),
                                           options.reduction, options.orientation);
  const ImageSize size{160, 90};
  const BatchImage batch = batch_image(image, size);
  const LensPosterior posterior = predictor.posteriors(std::span(&batch, 1)).front();
  const auto camera = to_camera(posterior.mean, TargetSpace::seen, size.width, size.height);
  REQUIRE(camera);
  CHECK(is_one_to_one(*camera));
  CHECK(posterior.mean[1] < -.1);
  CHECK(predictor(std::span(&batch, 1)).front() == posterior.mean);
}
