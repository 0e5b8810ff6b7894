#include <torch/types.h>

#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/onnx/onnx_interpreter.h"
#include "tests/trainer/onnx/random_model.h"
#include "trainer/model/predictor.h"
#include "trainer/network/tensor_batch.h"
#include "trainer/onnx/export_onnx.h"

using namespace cps;

TEST_CASE("the graph computes the predictor's labels") {
  const TemporaryFolder folder;
  TrainOptions options;
  options.reduction.width = 32;
  // The slow tests take every architecture, in ONNX Runtime.
  const auto [architecture, all_inputs] =
      GENERATE(table<std::string, bool>({{"resnet18", false}, {"resnet50", true}}));
  options.architecture = architecture;
  options.size_features = options.edge_channel = all_inputs;
  options.target_space = all_inputs ? TargetSpace::apparent : TargetSpace::raw;
  INFO(architecture);
  write_random_model(folder.path, options);
  const Predictor predictor(folder.path);
  write_onnx(folder.path, folder.path / "model.onnx");
  const ReadModel model = read_onnx(read_file(folder.path / "model.onnx"));

  // Two batches of different sizes, one image in the first, two in the second.
  std::vector<double> fields_of_view;
  for (const auto& [height, count] : {std::pair{54, 1}, std::pair{72, 2}}) {
    std::vector<GrayImage> reduced;
    std::vector<BatchImage> batch;
    const ImageSize original{96, height};
    for (int i = 0; i < count; ++i)
      reduced.push_back(area_average(numbered_street(height, i), reduced_size(original, options.reduction)));
    for (const GrayImage& image : reduced) batch.push_back({{image.size, image.pixels.data()}, original});

    const auto computed =
        run_onnx(model, {{"image", image_tensor(batch, {.mean = 0, .deviation = 1})},
                         {"size", torch::tensor({{float(height), 96.f}}).expand({count, 2})}});
    const std::vector<Outputs> predicted = predictor(batch);
    for (int i = 0; i < count; ++i) {
      const auto camera = to_camera(predicted[i], options.target_space, original.width, original.height);
      REQUIRE(camera);
      const auto expected = label_numbers(*camera);
      for (int k = 0; k < output_count; ++k) {
        INFO(output_names[k]);
        const torch::Tensor& column = computed.at(output_names[k]);
        REQUIRE(column.sizes() == torch::IntArrayRef({count}));
        CHECK(column[i].item<double>() == Approx(expected[k]).epsilon(1e-4).margin(1e-4));
      }
      fields_of_view.push_back(expected[0]);
    }
  }
  // The images do not all look the same to the network.
  CHECK(std::abs(fields_of_view[1] - fields_of_view[0]) > .01);
  CHECK(std::abs(fields_of_view[2] - fields_of_view[1]) > .01);
}
