#include <torch/types.h>

#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/images/orientation/drawings.h"
#include "tests/trainer/onnx/random_model.h"
#include "tests/trainer/street.h"
#include "trainer/evaluation/predict.h"
#include "trainer/images/network_image.h"
#include "trainer/network/orientation_tensors.h"
#include "trainer/network/weights.h"
#include "trainer/training/distillation.h"
#include "trainer/training/train.h"

using namespace cps;

namespace {

TrainOptions with_orientation() {
  TrainOptions options;
  options.architecture = "resnet18";
  options.reduction.width = 48;
  options.orientation.measured = true;
  return options;
}

NetworkImage image_of(const GrayImage& whole) {
  const TrainOptions options = with_orientation();
  return network_image(whole, options.reduction, options.orientation);
}

GrayImage street() {
  return render_street(draw_calibration({96, 56}, 70, 3), 5);
}

/// Normalises by statistics that are easy to check.
ModelCard round_card() {
  ModelCard card;
  card.options = with_orientation();
  card.orientation.plane_deviation.fill(.5);
  card.orientation.plane_mean.fill(.25);
  card.orientation.number_deviation.fill(2);
  card.orientation.number_mean.fill(-1);
  return card;
}

OrientationTensors tensors_of(const NetworkImage& image, bool mirror, const ModelCard& card) {
  const BatchImage member = batch_image(image, {96, 56}, mirror);
  return orientation_tensors(std::span(&member, 1), card);
}

}  // namespace

TEST_CASE("a network gets tilt times confidence, confidence and the numbers, normalised") {
  NetworkImage image = image_of(street());
  image.orientation.planes[5] = -40;                // a near-vertical tilt in the first row
  image.orientation.planes[2 * 24 * 14 + 5] = 100;  // and the confidence in it
  image.orientation.numbers[3] = .75f;
  const OrientationTensors tensors = tensors_of(image, false, round_card());
  REQUIRE(tensors.planes.sizes() == torch::IntArrayRef({1, 4, 14, 24}));
  REQUIRE(tensors.numbers.sizes() == torch::IntArrayRef({1, 28}));
  CHECK(tensors.planes[0][0][0][5].item<double>() ==
        Approx((-40. / 508 * 100 / 127 - .25) / .5).epsilon(1e-5));
  CHECK(tensors.planes[0][2][0][5].item<double>() == Approx((100. / 127 - .25) / .5).epsilon(1e-5));
  CHECK(tensors.numbers[0][3].item<double>() == Approx((.75 + 1) / 2));
  ModelCard without;
  CHECK_FALSE(tensors_of(image, false, without).planes.defined());
}

TEST_CASE("a flipped image of a batch has the orientation of the flipped picture") {
  const OrientationTensors a = tensors_of(image_of(street()), true, round_card()),
                           b = tensors_of(image_of(flipped(street())), false, round_card()),
                           not_flipped = tensors_of(image_of(street()), false, round_card());
  CHECK(torch::allclose(a.planes, b.planes, 1e-5, 1e-6));
  CHECK(torch::allclose(a.numbers, b.numbers, 1e-4, 1e-5));
  CHECK_FALSE(torch::allclose(a.planes, not_flipped.planes, 1e-2, 1e-2));
}

TEST_CASE("planes and numbers reach the prediction, each by itself") {
  const TemporaryFolder folder;
  write_random_model(folder.path, with_orientation());
  const Predictor predictor(folder.path);
  const NetworkImage image = image_of(street());
  NetworkImage other_planes = image, other_numbers = image;
  other_planes.orientation.planes = image_of(flipped(street())).orientation.planes;
  other_numbers.orientation.numbers[3] += .2f;
  std::vector<BatchImage> batch;
  const NetworkImage* const images[] = {&image, &other_planes, &other_numbers};
  for (const NetworkImage* one : images) batch.push_back(batch_image(*one, {96, 56}));
  const std::vector<Outputs> said = predictor(batch);
  for (int i : {1, 2}) {
    INFO(i);
    CHECK(std::abs(said[i][0] - said[0][0]) > 1e-4);
  }
}

TEST_CASE("cps predict measures the orientation of an image file at its own size") {
  const TemporaryFolder folder;
  write_random_model(folder.path, with_orientation());
  const GrayImage whole = street();
  write_file(folder.path / "street.pgm",
             "P5\n96 56\n255\n" + std::string(whole.pixels.begin(), whole.pixels.end()));
  const Predictor predictor(folder.path);
  const std::vector<std::filesystem::path> files{folder.path / "street.pgm"};
  const NetworkImage image = image_of(whole);
  const BatchImage member = batch_image(image, whole.size);
  const Outputs expected =
      convert(predictor(std::span(&member, 1))[0], TargetSpace::apparent, TargetSpace::raw, 96, 56);
  const ImagePrediction prediction = predict_images(predictor, files, {.variants = 4})[0];
  for (int k = 0; k < output_count; ++k) CHECK(prediction.raw[k] == Approx(expected[k]).epsilon(1e-6));
  CHECK(prediction.spread[0] > 0);
}

TEST_CASE("gray weights start a network with orientation, whose planes then have no effect") {
  torch::manual_seed(1);
  const Architecture& resnet18 = *find_architecture("resnet18");
  const auto gray = make_resnet(resnet18, {}), edges = make_resnet(resnet18, {.orientation = true});
  start_from(*edges, weights_of(*gray), "gray.pth");
  edges->eval();
  const torch::NoGradGuard no_gradients;
  for (auto& p : edges->named_parameters()) {
    if (p.key() == "orientation.weight") CHECK(p.value().abs().max().item<double>() == 0);
    if (p.key() == "fc.weight") {
      CHECK(p.value().sizes() == torch::IntArrayRef({8, 512 + 2 + 28}));
      p.value().normal_();
    }
  }
  // Odd sizes, too: the planes are as large as the first convolution's result.
  for (const ImageSize size : {ImageSize{96, 64}, ImageSize{95, 63}}) {
    const ImageSize grid = orientation_grid(size);
    const torch::Tensor image = torch::randn({2, 1, size.height, size.width}), sizes = torch::zeros({2, 2}),
                        numbers = torch::randn({2, 28});
    const auto predict = [&](double plane) {
      return edges->forward(image, sizes, {torch::full({2, 4, grid.height, grid.width}, plane), numbers})
          .numbers;
    };
    CHECK(torch::equal(predict(0), predict(1)));
  }
}

TEST_CASE("a teacher that takes orientation needs a student that takes the same") {
  const TemporaryFolder folder;
  write_random_model(folder.path, with_orientation());
  TrainOptions student = with_orientation();
  student.teacher = folder.path.string();
  CHECK_NOTHROW(load_teacher(student));
  student.orientation.max_width = 100;
  CHECK_THROWS_WITH(load_teacher(student), Catch::Contains("orientation-width"));
  student.orientation.measured = false;
  CHECK_THROWS_WITH(load_teacher(student), Catch::Contains("orientation of edges"));
}

TEST_CASE("training with orientation keeps its statistics in the card and resumes bit for bit") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path / "data", {.sizes = {{96, 54}},
                                                                     .fields_of_view = 2,
                                                                     .lenses_per_part = 2,
                                                                     .train_places = 2,
                                                                     .val_places = 1,
                                                                     .test_places = 1});
  TrainOptions options = with_orientation();
  options.epochs = 2;
  options.batch_size = 4;
  options.threads = 2;
  const auto model = [&](const char* name) { return folder.path / name; };
  train(dataset, model("whole"), options, false, {});
  train(dataset, model("parts"), options, false, [](const EpochReport&) { return false; });
  train(dataset, model("parts"), {}, true, {});
  CHECK(read_file(model("whole") / "weights.pt") == read_file(model("parts") / "weights.pt"));
  const ModelCard card = load_model_card(model("whole"));
  CHECK(card.options.orientation == options.orientation);
  for (double deviation : card.orientation.plane_deviation) CHECK(deviation > 0);
  for (double deviation : card.orientation.number_deviation) CHECK(deviation > 0);
  const NamedTensors weights = load_tensors(model("whole") / "weights.pt");
  CHECK(weights.at("orientation.weight").sizes() == torch::IntArrayRef({64, 4, 3, 3}));
}
