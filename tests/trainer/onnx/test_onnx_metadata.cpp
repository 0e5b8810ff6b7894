#include <catch2/catch.hpp>
#include <map>

#include "trainer/onnx/onnx_metadata.h"

using namespace cps;

namespace {

std::map<std::string, std::string> metadata_of(const ModelCard& card) {
  const auto entries = onnx_metadata(card, "abc");
  std::map<std::string, std::string> metadata(entries.begin(), entries.end());
  CHECK(metadata.size() == entries.size());  // no name twice
  return metadata;
}

}  // namespace

TEST_CASE("the metadata say how to make the inputs, what the outputs are, and which model it is") {
  ModelCard card{.options = {},
                 .pixels = {.mean = 111.7, .deviation = 57.3},
                 .targets = {.mean = {1.3, -.08, .02, -.003, .0004, -.0003, .503, .497},
                             .deviation = {.15, .1, .05, .02, .002, .003, 1, 1}},
                 .dataset = "/home/somebody/data",
                 .dataset_hash = "0123456789abcdef",
                 .training_images = 8,
                 .validation_images = 4,
                 .epoch = 3,
                 .validation_loss = .25};
  card.options.target_space = TargetSpace::raw;
  card.options.outputs = {"fov", "k1"};
  card.options.edge_channel = true;
  auto metadata = metadata_of(card);
  CHECK_THAT(metadata["input_gray"], Catch::Contains("0.2126 R + 0.7152 G + 0.0722 B"));
  CHECK_THAT(metadata["input_size"], Catch::EndsWith("scale = min(1, 160 / original width)"));
  CHECK_THAT(metadata["input_resampling"], Catch::StartsWith("area average"));
  CHECK(metadata["input_normalisation"] == "in the graph: (pixel - 111.7) / 57.3");
  CHECK(metadata["output_names"] == "fov k1 k2 k3 p1 p2 cx cy");
  CHECK(metadata["output_units"] == "deg 1 1 1 1 1 px px");
  CHECK(metadata["output_learned"] == "fov k1");
  CHECK_THAT(metadata["output_not_in_graph"], Catch::Contains("certified"));
  CHECK(metadata["target_space"] == "raw");
  CHECK(metadata["target_mean"] == "1.3 -0.08 0.02 -0.003 0.0004 -0.0003 0.503 0.497");
  CHECK(metadata["target_deviation"] == "0.15 0.1 0.05 0.02 0.002 0.003 1 1");
  CHECK(metadata["architecture"] == "resnet18");
  CHECK(metadata["size_features"] == "true");
  CHECK(metadata["edge_channel"] == "true");
  CHECK(metadata["model_card_schema"] == "2");
  CHECK(metadata["model_epoch"] == "3");
  CHECK(metadata["model_validation_loss"] == "0.25");
  CHECK(metadata["dataset_hash"] == "0123456789abcdef");
  CHECK(metadata["weights_sha256"] == "abc");
  for (const auto& [name, text] : metadata) CHECK_THAT(text, !Catch::Contains("somebody"));

  CHECK_FALSE(metadata.contains("orientation"));
  card.options.orientation = {.measured = true, .max_width = 777};
  metadata = metadata_of(card);
  CHECK(metadata["orientation"] == "true");
  CHECK_THAT(metadata["input_edges"], Catch::Contains("width 777"));
  CHECK_THAT(metadata["input_edge_fit"],
             Catch::Contains("vertical_tilt_xy") && Catch::EndsWith("horizontal_residual"));

  card.options.reduction.factor = 4;
  CHECK_THAT(metadata_of(card)["input_size"], Catch::EndsWith("scale = 1 / 4"));
}
