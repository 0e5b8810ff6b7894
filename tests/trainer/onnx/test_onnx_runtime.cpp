#include <catch2/catch.hpp>
#include <cstdlib>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "tests/trainer/onnx/random_model.h"
#include "trainer/evaluation/predict.h"
#include "trainer/network/architectures.h"
#include "trainer/onnx/export_onnx.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

int shell_in(const fs::path& folder, const std::string& command) {
  return std::system(("cd " + folder.string() + " && " + command).c_str());
}

/// A colour picture of 96×`height` pixels: three streets, one to a channel.
void write_picture(const fs::path& file, int height, int number) {
  std::string ppm = "P6\n96 " + std::to_string(height) + "\n255\n";
  const GrayImage channels[] = {numbered_street(height, number), numbered_street(height, number + 1),
                                numbered_street(height, number + 2)};
  for (std::size_t i = 0; i < channels[0].pixels.size(); ++i)
    for (const GrayImage& channel : channels) ppm += static_cast<char>(channel.pixels[i]);
  write_file(file, ppm);
}

/// The folder's model.onnx by ONNX's own checker, which also infers all shapes.
constexpr const char* check_with_onnx = R"(
import onnx
model = onnx.load("model.onnx")
onnx.checker.check_model(model, full_check=True)
names = [output.name for output in model.graph.output]
assert names == "fov k1 k2 k3 p1 p2 cx cy".split(), names
inferred = onnx.shape_inference.infer_shapes(model, strict_mode=True)
shapes = {value.name: [d.dim_param or d.dim_value for d in value.type.tensor_type.shape.dim]
          for value in inferred.graph.value_info}
assert shapes["fc"] == ["N", 8], shapes["fc"]
metadata = {entry.key: entry.value for entry in model.metadata_props}
assert metadata["output_names"].split() == names
)";

}  // namespace

TEST_CASE("ONNX Runtime predicts from pictures what cps predict does, with every architecture", "[slow]") {
  const TemporaryFolder temporary;
  const fs::path& folder = temporary.path;
  if (shell_in(folder, "npm install --silent onnxruntime-web@1.23.2 > npm.log 2>&1") != 0)
    FAIL("npm could not install onnxruntime-web: install npm and allow it to reach its registry");
  fs::copy_file(CPS_SOURCE "/tests/trainer/onnx/predict.js", folder / "predict.js");
  write_file(folder / "check.py", std::string(check_with_onnx));
  std::vector<fs::path> pictures;
  for (const auto& [height, number] : {std::pair{54, 0}, std::pair{72, 1}, std::pair{72, 2}}) {
    pictures.push_back("picture" + std::to_string(number) + ".ppm");
    write_picture(folder / pictures.back(), height, number);
  }

  for (const Architecture& architecture : architectures())
    for (const bool is_default : {true, false}) {
      TrainOptions options;
      options.architecture = architecture.name;
      options.reduction = is_default ? Reduction{.width = 32} : Reduction{.factor = 3};
      options.size_features = is_default;
      options.edge_channel = !is_default;
      options.target_space = is_default ? TargetSpace::apparent : TargetSpace::raw;
      INFO(architecture.name << (is_default ? "" : ", with edges, without sizes, raw"));
      write_random_model(folder, options);
      write_onnx(folder, folder / "model.onnx");
      REQUIRE(shell_in(folder, "/usr/bin/python3 check.py") == 0);  // apt-get install python3-onnx

      const std::string predict = "node predict.js model.onnx " + std::to_string(options.reduction.width) +
                                  " " + std::to_string(options.reduction.factor);
      REQUIRE(shell_in(folder, predict + " picture0.ppm > one.json") == 0);
      REQUIRE(shell_in(folder, predict + " picture1.ppm picture2.ppm > two.json") == 0);
      nlohmann::json theirs = read_json(folder / "one.json");
      for (const auto& outputs : read_json(folder / "two.json")) theirs.push_back(outputs);

      std::vector<fs::path> files;
      for (const fs::path& picture : pictures) files.push_back(folder / picture);
      const std::vector<ImagePrediction> ours = predict_images(Predictor(folder), files, {.variants = 0});
      REQUIRE(theirs.size() == ours.size());
      for (std::size_t i = 0; i < ours.size(); ++i) {
        REQUIRE(ours[i].camera);
        const auto expected = label_numbers(*ours[i].camera);
        for (int k = 0; k < output_count; ++k) {
          INFO(pictures[i].string() << " " << output_names[k]);
          CHECK(theirs[i][k].get<double>() == Approx(expected[k]).epsilon(1e-4).margin(1e-4));
        }
      }
    }
}
