#include "trainer/evaluation/predict.h"

#include <iostream>
#include <stdexcept>

#include "apps/options.h"
#include "apps/pictures/picture_file.h"
#include "apps/train/usage.h"
#include "apps/train/verbs.h"
#include "dataset/exchange/calibration_file.h"
#include "dataset/exchange/camera_pictures.h"
#include "distortion/warp/view_fit.h"
#include "files/files.h"
#include "trainer/network/threads.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

struct Request {
  std::string model, json, cameras, format = "opencv-yaml", straight, device = "cpu";
  std::vector<std::string> images;
  int threads = 0;
  PredictOptions options;
};

po::options_description describe(Request& r) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("model", po::value(&r.model)->required(), "the model's folder");
  add("image", po::value(&r.images)->required(),
      "pictures, or folders of them; may be given without --image");
  add("json", po::value(&r.json), "write the numbers to this file as well");
  add("cameras", po::value(&r.cameras), "a folder: a calibration for each picture, of a certified lens");
  add("format", po::value(&r.format)->default_value(r.format),
      "of those: cps, opencv-yaml, opencv-xml, colmap, ros, kitti, kalibr, nerfstudio");
  add("undistort", po::value(&r.straight),
      "a folder: each picture straightened by what was predicted, no black");
  add("looks", po::value(&r.options.looks)->default_value(r.options.looks),
      "changed looks at each picture that its spread is taken from; 0: none");
  add("device", po::value(&r.device)->default_value(r.device), "cpu or cuda");
  add("threads", po::value(&r.threads)->default_value(r.threads), "0: all cores");
  return options;
}

std::vector<fs::path> pictures(const std::vector<std::string>& names) {
  std::vector<fs::path> files;
  for (const std::string& name : names) {
    const std::vector<fs::path> found =
        fs::is_directory(name) ? pictures_in(name) : std::vector<fs::path>{name};
    files.insert(files.end(), found.begin(), found.end());
  }
  return files;
}

CalibratedCamera camera_of(const ImagePrediction& p) {
  return {p.file.stem().string(), p.certified->calibration.camera, p.certified->calibration.distortion};
}

void straighten(const ImagePrediction& p, const fs::path& folder) {
  const CalibratedCamera camera = camera_of(p);
  const ViewFit view = fit_straight_view(camera, Keep::valid, p.size.width, p.size.height, .5);
  if (!view.valid) throw std::runtime_error(p.file.string() + ": " + view.why);
  const Picture picture =
      read_picture(p.file, Encoding::automatic, Resampling::footprint, p.size.width, p.size.height);
  const WarpOptions options{.oversampling = 1, .require_coverage = false, .require_resolution = false};
  write_picture(folder / p.file.filename(),
                unwarp(picture.pixels, camera.pinhole, camera.distortion, view.camera, options), picture);
}

}  // namespace

int predict_verb(const Arguments& arguments) {
  Request request;
  po::positional_options_description positional;
  positional.add("image", -1);
  po::variables_map values;
  if (!parse_options(
          arguments,
          "cps predict --model MODEL IMAGE...\nWhat a trained network says of images: H-FOV, distortion and "
          "principal point; beside it the truth, where a calibration.json lies beside the image. What is "
          "written as "
          "a camera or used to straighten is pulled to a certified lens where the prediction is none.\n",
          describe(request), positional, values))
    return 0;
  po::notify(values);
  if (request.options.looks < 0 || request.options.looks > 1000)
    throw po::error("--looks: must lie in [0, 1000]");
  const CalibrationFormat format =
      usage_checked([&] { return calibration_format_from_string(request.format); });
  const Device device = usage_checked([&] { return device_from_string(request.device); });
  use_threads(request.threads);

  const Predictor predictor(request.model, device);
  const std::vector<ImagePrediction> predictions =
      predict_images(predictor, pictures(request.images), request.options);
  std::cout << report(predictions);
  if (!request.json.empty()) write_json(request.json, to_json(predictions));
  for (const ImagePrediction& p : predictions) {
    if (!p.certified) continue;
    const std::string name = p.file.stem().string() + "_" + usual_file_name(format);
    if (!request.cameras.empty())
      write_calibration(fs::path(request.cameras) / name, format, std::vector{camera_of(p)});
    if (!request.straight.empty()) straighten(p, request.straight);
  }
  return 0;
}

}  // namespace cps
