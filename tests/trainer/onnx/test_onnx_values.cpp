#include <torch/types.h>

#include <catch2/catch.hpp>
#include <map>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/onnx/onnx_interpreter.h"
#include "tests/trainer/onnx/random_model.h"
#include "trainer/images/network_image.h"
#include "trainer/model/predictor.h"
#include "trainer/network/tensor_batch.h"
#include "trainer/onnx/export_onnx.h"

using namespace cps;

namespace {

/// The inputs for the orientation, as docs/formats.md describes them.
void add_edges(std::map<std::string, torch::Tensor>& inputs, const std::vector<NetworkImage>& images) {
  std::vector<torch::Tensor> tilts, confidences, fits;
  for (const NetworkImage& image : images) {
    const Orientation& edges = image.orientation;
    const torch::Tensor planes = torch::tensor(std::vector<float>(edges.planes.begin(), edges.planes.end()))
                                     .view({orientation_plane_count, edges.grid.height, edges.grid.width});
    tilts.push_back(planes.slice(0, 0, 2) / 508);
    confidences.push_back(planes.slice(0, 2, 4) / 127);
    fits.push_back(torch::tensor(std::vector<float>(edges.numbers.begin(), edges.numbers.end())));
  }
  inputs["edge_tilt"] = torch::stack(tilts);
  inputs["edge_confidence"] = torch::stack(confidences);
  inputs["edge_fit"] = torch::stack(fits);
}

}  // namespace

TEST_CASE("the graph computes the predictor's labels") {
  const TemporaryFolder folder;
  TrainOptions options;
  options.reduction.width = 32;
  // The slow tests take every architecture, in ONNX Runtime.
  const auto [architecture, all_inputs] =
      GENERATE(table<std::string, bool>({{"resnet18", false}, {"resnet50", true}}));
  options.architecture = architecture;
  options.size_features = options.edge_channel = options.orientation.measured = all_inputs;
  options.target_space = all_inputs ? TargetSpace::apparent : TargetSpace::raw;
  INFO(architecture);
  write_random_model(folder.path, options);
  const Predictor predictor(folder.path);
  write_onnx(folder.path, folder.path / "model.onnx");
  const ReadModel model = read_onnx(read_file(folder.path / "model.onnx"));

  // Two batches of different sizes, one image in the first, two in the second.
  std::vector<double> fields_of_view;
  for (const auto& [height, count] : {std::pair{54, 1}, std::pair{72, 2}}) {
    std::vector<NetworkImage> reduced;
    std::vector<BatchImage> batch;
    const ImageSize original{96, height};
    for (int i = 0; i < count; ++i)
      reduced.push_back(network_image(numbered_street(height, i), options.reduction, options.orientation));
    for (const NetworkImage& image : reduced) batch.push_back(batch_image(image, original));

    std::map<std::string, torch::Tensor> inputs{
        {"image", image_tensor(batch, {.mean = 0, .deviation = 1})},
        {"size", torch::tensor({{float(height), 96.f}}).expand({count, 2})}};
    if (options.orientation.measured) add_edges(inputs, reduced);
    const auto computed = run_onnx(model, inputs);
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
