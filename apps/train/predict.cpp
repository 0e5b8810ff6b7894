#include "trainer/predict.h"

#include <iostream>

#include "apps/options.h"
#include "apps/train/verbs.h"
#include "dataset/files.h"
#include "trainer/threads.h"

namespace po = boost::program_options;

namespace cps {

int predict_verb(const Arguments& arguments) {
  std::string model, json;
  std::vector<std::string> images;
  po::options_description options("Options");
  options.add_options()("model", po::value<std::string>(&model)->required(), "the model's folder")(
      "image", po::value<std::vector<std::string>>(&images)->required(),
      "PNG or JPEG; may be given without --image")("json", po::value<std::string>(&json),
                                                   "write the numbers to this file as well");
  po::positional_options_description positional;
  positional.add("image", -1);
  po::variables_map values;
  if (!parse_options(
          arguments,
          "cps predict --model MODEL IMAGE...\nWhat a trained network says of images: H-FOV, distortion and "
          "principal point; beside it the truth, where a calibration.json lies beside the image.\n",
          options, positional, values))
    return 0;
  po::notify(values);
  use_threads(0);

  const Predictor predictor{std::filesystem::path(model)};
  const std::vector<ImagePrediction> predictions =
      predict_images(predictor, std::vector<std::filesystem::path>(images.begin(), images.end()));
  std::cout << report(predictions);
  if (!json.empty()) write_json(json, to_json(predictions));
  return 0;
}

}  // namespace cps
