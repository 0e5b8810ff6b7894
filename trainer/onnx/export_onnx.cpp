#include "trainer/onnx/export_onnx.h"

#include <stdexcept>

#include "dataset/labels/group_label.h"
#include "files/files.h"
#include "trainer/model/make_network.h"
#include "trainer/model/predictor.h"
#include "trainer/network/weights.h"
#include "trainer/onnx/label_graph.h"
#include "trainer/onnx/onnx_bytes.h"
#include "trainer/onnx/onnx_metadata.h"
#include "trainer/onnx/resnet_graph.h"

namespace cps {
namespace {

OnnxGraph graph_of(const Network& network, const ModelCard& card) {
  const TrainOptions& options = card.options;
  OnnxGraph graph;
  graph.name = options.architecture;
  const std::string image = "image", size = "size";
  graph.inputs = {{image, "gray pixels of the reduced images, 0 to 255", {"N", 1, "H", "W"}},
                  {size, "height and width of the original images, pixels", {"N", 2}}};
  const std::string input = add_input_layers(graph, image, card.pixels, options.edge_channel);
  OrientationInputs orientation;
  if (options.orientation.measured) {
    const std::string tilt = "edge_tilt", confidence = "edge_confidence", fit = "edge_fit";
    graph.inputs.push_back({tilt, "tilts of near-vertical and near-horizontal edges", {"N", 2, "H2", "W2"}});
    graph.inputs.push_back({confidence, "confidences in these tilts, 0 to 1", {"N", 2, "H2", "W2"}});
    graph.inputs.push_back({fit, "numbers of the fits to these tilts", {"N", orientation_number_count}});
    orientation = add_orientation_layers(graph, tilt, confidence, fit, card.orientation);
  }
  const std::string outputs =
      add_resnet(graph, input, size, orientation, *find_architecture(options.architecture),
                 network_options(options), weights_of(network));
  add_label_outputs(graph, outputs, size, card.targets, options.target_space);
  return graph;
}

}  // namespace

std::string onnx_fault(const TrainOptions& options) {
  if (is_deepcalib(options.head))
    return "head: is " + to_string(options.head) + ": only networks of Brown-Conrady lenses can be exported";
  if (is_fit(options.head))
    return "head: is " + to_string(options.head) + ": a fit has no ONNX form: train with --head direct";
  if (options.target_space == TargetSpace::seen)
    return "target_space: is seen, which has no ONNX form: train with --targets apparent";
  return "";
}

void write_onnx(const std::filesystem::path& model_folder, const std::filesystem::path& file) {
  const Predictor predictor(model_folder);
  if (const std::string fault = onnx_fault(predictor.card().options); !fault.empty())
    throw std::runtime_error((model_folder / "model.json").string() + ": " + fault);
  const std::string generator = generator_name();  // program and version
  const std::size_t space = generator.find(' ');
  const OnnxModel model{
      .producer = generator.substr(0, space),
      .producer_version = generator.substr(space + 1),
      .description =
          "Reads field of view, lens distortion and principal point of a camera from one image. The "
          "metadata say how to make the inputs and what the outputs are.",
      .graph = graph_of(predictor.network(), predictor.card()),
      .metadata = onnx_metadata(predictor.card(), sha256(read_file(model_folder / "weights.pt")))};
  write_file(file, onnx_bytes(model));
}

}  // namespace cps
