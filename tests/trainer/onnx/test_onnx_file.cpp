#include <torch/types.h>

#include <catch2/catch.hpp>
#include <set>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/onnx/onnx_interpreter.h"
#include "tests/trainer/onnx/random_model.h"
#include "tests/trainer/street.h"
#include "trainer/network/tensor_file.h"
#include "trainer/onnx/export_onnx.h"
#include "trainer/training/train.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> labels{"fov", "k1", "k2", "k3", "p1", "p2", "cx", "cy"};

TrainOptions with_edges() {
  TrainOptions options;
  options.edge_channel = true;
  options.seed = 4;
  return options;
}

/// Writes a random model and its ONNX file in a folder. Returns the file's bytes.
std::string random_onnx(const fs::path& folder, const TrainOptions& options) {
  write_random_model(folder, options);
  write_onnx(folder, folder / "model.onnx");
  return read_file(folder / "model.onnx");
}

}  // namespace

TEST_CASE("an ONNX file names its inputs, and as outputs the eight labels in their order") {
  const TemporaryFolder folder;
  const ReadModel model = read_onnx(random_onnx(folder.path, with_edges()));
  CHECK(model.ir_version == 8);
  CHECK(model.operator_set == 17);
  CHECK(model.domain.empty());
  CHECK(model.producer == "cps");
  CHECK(model.graph_name == "resnet18");
  REQUIRE(model.inputs.size() == 2);
  CHECK(model.inputs[0].name == "image");
  CHECK(model.inputs[0].type == 1);
  CHECK(model.inputs[0].shape == std::vector<std::string>{"N", "1", "H", "W"});
  CHECK(model.inputs[1].name == "size");
  CHECK(model.inputs[1].shape == std::vector<std::string>{"N", "2"});
  std::vector<std::string> names;
  for (const ReadValue& output : model.outputs) {
    names.push_back(output.name);
    CHECK(output.type == 1);
    CHECK(output.shape == std::vector<std::string>{"N"});
    CHECK_FALSE(output.description.empty());
  }
  CHECK(names == labels);
  CHECK(model.metadata.at("output_names") == "fov k1 k2 k3 p1 p2 cx cy");
  CHECK(model.metadata.at("weights_sha256") == sha256(read_file(folder.path / "weights.pt")));
}

TEST_CASE("a network with orientation has three inputs more") {
  const TemporaryFolder folder;
  TrainOptions options = with_edges();
  options.orientation.measured = true;
  const ReadModel model = read_onnx(random_onnx(folder.path, options));
  REQUIRE(model.inputs.size() == 5);
  CHECK(model.inputs[2].name == "edge_tilt");
  CHECK(model.inputs[2].shape == std::vector<std::string>{"N", "2", "H2", "W2"});
  CHECK(model.inputs[3].name == "edge_confidence");
  CHECK(model.inputs[3].shape == std::vector<std::string>{"N", "2", "H2", "W2"});
  CHECK(model.inputs[4].name == "edge_fit");
  CHECK(model.inputs[4].shape == std::vector<std::string>{"N", "28"});
  CHECK(model.metadata.at("orientation") == "true");
}

TEST_CASE("an ONNX file holds the weights bit for bit under their names, and nothing that is not used") {
  const TemporaryFolder folder;
  const ReadModel model = read_onnx(random_onnx(folder.path, with_edges()));
  for (const auto& [name, tensor] : load_tensors(folder.path / "weights.pt")) {
    if (name.ends_with("num_batches_tracked")) continue;  // counts training steps
    INFO(name);
    REQUIRE(model.constants.contains(name));
    CHECK(torch::equal(to_torch(model.constants.at(name)), tensor));
  }
  std::set<std::string> used(labels.begin(), labels.end());
  for (const ReadNode& node : model.nodes) {
    CHECK(node.outputs == std::vector{node.name});
    used.insert(node.inputs.begin(), node.inputs.end());
  }
  for (const ReadNode& node : model.nodes) CHECK(used.contains(node.name));
  for (const auto& [name, constant] : model.constants) CHECK(used.contains(name));
}

TEST_CASE("the same weights give the same bytes in any folder") {
  const TemporaryFolder a, b;
  CHECK(random_onnx(a.path, with_edges()) == random_onnx(b.path, with_edges()));
}

TEST_CASE("a folder without a whole model is refused in one line, and no file appears") {
  const TemporaryFolder folder;
  const fs::path file = folder.path / "out" / "a.onnx";
  CHECK_THROWS_WITH(write_onnx(folder.path / "none", file), Catch::Contains("model.json: is missing"));
  write_random_model(folder.path, with_edges());
  fs::remove(folder.path / "weights.pt");
  CHECK_THROWS_WITH(write_onnx(folder.path, file), Catch::Contains("weights.pt: ") && !Catch::Contains("\n"));
  save_tensors({{"conv1.weight", torch::zeros({1})}}, folder.path / "weights.pt");
  CHECK_THROWS_WITH(write_onnx(folder.path, file), Catch::Contains("another architecture"));
  CHECK_FALSE(fs::exists(file));
}

TEST_CASE("training takes away an ONNX file of other weights") {
  const TemporaryFolder folder;
  const Dataset dataset = make_street_dataset(folder.path / "data", {.sizes = {{64, 36}},
                                                                     .fields_of_view = 2,
                                                                     .lenses_per_part = 1,
                                                                     .train_places = 1,
                                                                     .val_places = 1,
                                                                     .test_places = 1});
  const fs::path model = folder.path / "model", file = model / onnx_file_name;
  write_file(file, std::string("of other weights"));
  TrainOptions options;
  options.reduction.width = 32;
  options.epochs = 1;
  train(dataset, model, options, false, {});
  CHECK_FALSE(fs::exists(file));
}
