#include <torch/types.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/onnx/random_model.h"
#include "trainer/images/network_image.h"
#include "trainer/model/half_model.h"
#include "trainer/model/predictor.h"
#include "trainer/network/tensor_file.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

TrainOptions small_options() {
  TrainOptions options;
  options.architecture = "resnet10-32";
  options.reduction.width = 32;
  options.orientation.measured = true;
  return options;
}

std::vector<Outputs> predictions_of(const fs::path& model) {
  const Predictor predictor(model);
  const TrainOptions& options = predictor.card().options;
  std::vector<NetworkImage> reduced;
  std::vector<BatchImage> batch;
  for (int i = 0; i < 3; ++i)
    reduced.push_back(network_image(numbered_street(54, i), options.reduction, options.orientation));
  for (const NetworkImage& image : reduced) batch.push_back(batch_image(image, ImageSize{96, 54}));
  return predictor(batch);
}

/// The same model with its weights as float32.
void write_widened(const fs::path& half, const fs::path& wide) {
  NamedTensors weights;
  for (const auto& [name, tensor] : load_tensors(half / "weights.pt"))
    weights[name] = tensor.is_floating_point() ? tensor.to(torch::kFloat) : tensor;
  save_tensors(weights, wide / "weights.pt");
  ModelCard card = load_model_card(half);
  card.has_half_weights = false;
  save_model_card(card, wide);
}

bool are_same_models(const fs::path& a, const fs::path& b) {
  return read_file(a / "weights.pt") == read_file(b / "weights.pt") &&
         read_file(a / "model.json") == read_file(b / "model.json");
}

}  // namespace

TEST_CASE("a half model predicts what its weights predict in float32 and nearly what the model predicts") {
  const TemporaryFolder folder;
  const fs::path full = folder.path / "full", half = folder.path / "half", wide = folder.path / "wide";
  write_random_model(full, small_options());
  write_half_model(full, half);
  write_widened(half, wide);
  const std::vector<Outputs> of_full = predictions_of(full), of_half = predictions_of(half);
  CHECK((of_half == predictions_of(wide)));
  CHECK((of_half != of_full));  // the weights were rounded
  const Standardisation targets = load_model_card(full).targets;
  for (std::size_t i = 0; i < of_full.size(); ++i)
    for (int k = 0; k < output_count; ++k) {
      INFO("image " << i << ", " << output_names[k]);
      const double size = targets.deviation[k] + std::abs(of_full[i][k] - targets.mean[k]);
      CHECK(std::abs(of_half[i][k] - of_full[i][k]) < .05 * size);
    }
}

TEST_CASE("a half model is half as large and its card is the model's with one line more") {
  const TemporaryFolder folder;
  const fs::path full = folder.path / "full", half = folder.path / "half", wide = folder.path / "wide";
  write_random_model(full, small_options());
  write_half_model(full, half);
  CHECK(fs::file_size(half / "weights.pt") < .52 * fs::file_size(full / "weights.pt"));
  CHECK_THAT(read_file(half / "model.json"), Catch::Contains("\"weights\": \"float16\""));
  write_widened(half, wide);
  CHECK((read_file(wide / "model.json") == read_file(full / "model.json")));
}

TEST_CASE("a copy of a copy is the copy and no float32 weights are overwritten") {
  const TemporaryFolder folder;
  const fs::path full = folder.path / "full", half = folder.path / "half", other = folder.path / "other";
  write_random_model(full, small_options());
  write_half_model(full, half);
  write_half_model(half, other);
  CHECK(are_same_models(half, other));
  write_half_model(full, other);
  CHECK(are_same_models(half, other));
  write_half_model(half, half);
  CHECK(are_same_models(half, other));

  const std::string weights = read_file(full / "weights.pt");
  for (const fs::path& from : {full, half})
    CHECK_THROWS_WITH(write_half_model(from, full),
                      Catch::StartsWith(full.string() + ": ") && Catch::Contains("another folder"));
  CHECK((read_file(full / "weights.pt") == weights));
  CHECK_THROWS_WITH(write_half_model(folder.path / "none", folder.path / "new"),
                    Catch::Contains("model.json: is missing"));
  CHECK_FALSE(fs::exists(folder.path / "new"));
}
