#include "trainer/evaluation/predict.h"

#include <iostream>
#include <stdexcept>

#include "apps/options.h"
#include "apps/pictures/picture_file.h"
#include "apps/train/summaries.h"
#include "apps/train/usage.h"
#include "apps/train/verbs.h"
#include "dataset/exchange/calibration_file.h"
#include "dataset/exchange/camera_pictures.h"
#include "dataset/exchange/model_calibration.h"
#include "distortion/warp/view_fit.h"
#include "files/files.h"
#include "trainer/evaluation/predict_spheres.h"
#include "trainer/network/threads.h"
#include "trainer/onnx/export_onnx.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

struct PredictRequest {
  std::string model, json, cameras, format = "opencv-yaml", undistorted, device = "cpu", exported_as, out;
  std::vector<std::string> images;
  int threads = 0;
  PredictOptions options;
};

po::options_description describe(PredictRequest& r) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("model", po::value(&r.model)->value_name("MODEL")->required(), "model folder");
  add("image", po::value(&r.images)->value_name("PATH"),
      "pictures, or folders of pictures; --image itself may be omitted");
  add("json", po::value(&r.json)->value_name("FILE"), "also write the predictions to this JSON file");
  add("cameras", po::value(&r.cameras)->value_name("FOLDER"),
      "folder for calibration files, one per picture, each with a certified lens");
  add("format", po::value(&r.format)->value_name("FORMAT")->default_value(r.format),
      "format of the calibration files: cps, opencv-yaml, opencv-xml, colmap, ros, kitti, kalibr, nerfstudio");
  add("undistort", po::value(&r.undistorted)->value_name("FOLDER"),
      "folder for undistorted pictures, made with the predicted lens and without black borders");
  add("export", po::value(&r.exported_as)->value_name("FORMAT"),
      "instead of predicting, write the network in the format of other programs: onnx");
  add("out,o", po::value(&r.out)->value_name("FILE"), "file that --export writes [MODEL/model.onnx]");
  add("variants", po::value(&r.options.variants)->default_value(r.options.variants),
      "variants of each picture whose predictions give the spread; 0: no spread");
  add("device", po::value(&r.device)->value_name("DEVICE")->default_value(r.device),
      "where to compute: cpu or cuda");
  add("threads", po::value(&r.threads)->default_value(r.threads), "number of threads; 0 means one per core");
  return options;
}

/// Throws if options are missing, or do not go together.
void check(const PredictRequest& r) {
  if (r.options.variants < 0 || r.options.variants > 1000)
    throw po::error("--variants: must lie in [0, 1000]");
  if (r.exported_as.empty()) {
    if (r.images.empty()) throw po::error("name the pictures to predict, or --export onnx");
    if (!r.out.empty()) throw po::error("--out: belongs to --export onnx; for predictions use --json FILE");
    return;
  }
  if (r.exported_as != "onnx") throw po::error("--export " + r.exported_as + ": must be onnx");
  if (!r.images.empty() || !r.json.empty() || !r.cameras.empty() || !r.undistorted.empty())
    throw po::error(
        "--export: writes the network and predicts nothing: leave out pictures, --json, --cameras "
        "and --undistort");
}

void export_network(const PredictRequest& r) {
  const fs::path file = r.out.empty() ? fs::path(r.model) / onnx_file_name : fs::path(r.out);
  write_onnx(r.model, file);
  std::cout << "written to " << file.string() << "\n";
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

void write_undistorted(const ImagePrediction& p, const fs::path& folder) {
  const CalibratedCamera& camera = p.certified->camera;
  const ViewFit view = fit_straight_view(camera, Keep::valid, p.size.width, p.size.height, .5);
  if (!view.valid) throw std::runtime_error(p.file.string() + ": " + view.why);
  const Picture picture =
      read_picture(p.file, Encoding::automatic, Resampling::footprint, p.size.width, p.size.height);
  const WarpOptions options{.oversampling = 1, .require_coverage = false, .require_resolution = false};
  write_picture(folder / p.file.filename(),
                unwarp(picture.pixels, camera.pinhole, camera.distortion, view.camera, options), picture);
}

/// What is asked for of a network with a DeepCalib head.
void predict_all_spheres(const PredictRequest& request, const Predictor& predictor,
                         CalibrationFormat format) {
  if (!request.undistorted.empty())
    throw po::error("--undistort: a deepcalib model writes --cameras, which cps undistort --lens takes");
  const LensModel family = UnifiedSpherical{};
  if (!request.cameras.empty() && !can_hold(format, family))
    throw po::error("--format " + to_string(format) +
                    ": cannot hold the unified_spherical lenses of a deepcalib model; cps, opencv-yaml, "
                    "opencv-xml and kalibr can");
  const std::vector<SpherePrediction> predictions = predict_spheres(predictor, pictures(request.images));
  std::cout << report(predictions);
  if (!request.json.empty()) write_json(request.json, to_json(predictions));
  if (request.cameras.empty()) return;
  for (const SpherePrediction& p : predictions)
    write_model_calibration(
        fs::path(request.cameras) / (p.file.stem().string() + "_" + usual_file_name(format)), format,
        std::vector{p.camera});
}

}  // namespace

const Manual predict_manual{
    .name = "cps predict",
    .summary = predict_line.text,
    .synopsis = {"--model MODEL [--json FILE] [--cameras FOLDER] [--undistort FOLDER] IMAGE...",
                 "--model MODEL --export onnx [-o FILE]"},
    .description = R"(
Runs a trained network on pictures: prints H-FOV, distortion and principal
point, and the true values if a calibration.json lies beside the picture.

Calibration files and undistorted pictures use a certified lens: if the
predicted one is not certified, its distortion is reduced until it is.

A model of a deepcalib preset prints the focal length and xi of a
unified_spherical camera, and its errors against the truth in ray space; there
is no spread and no --undistort.

The second form predicts nothing: it writes the network as a file that other
programs can run. Its metadata say what its inputs and outputs are.
)",
    .examples = {{"cps predict --model model photo.jpg", "prints what the network sees in one picture"},
                 {"cps predict --model model --cameras cameras --undistort straight photos",
                  "writes a calibration file and a straightened picture for each one of a folder"},
                 {"cps predict --model model --export onnx -o lens.onnx",
                  "writes the network for ONNX Runtime and its like"}},
    .see_also = {"cps train", "cps eval", "cps undistort"},
};

int predict_verb(const Arguments& arguments) {
  PredictRequest request;
  po::positional_options_description positional;
  positional.add("image", -1);
  po::variables_map values;
  if (!parse_options(arguments, predict_manual, describe(request), positional, values)) return 0;
  po::notify(values);
  check(request);
  const CalibrationFormat format =
      usage_checked([&] { return calibration_format_from_string(request.format); });
  const Device device = usage_checked([&] { return device_from_string(request.device); });
  if (!request.exported_as.empty()) {
    export_network(request);
    return 0;
  }
  use_threads(request.threads);

  const Predictor predictor(request.model, device);
  if (is_deepcalib(predictor.card().options.head)) {
    predict_all_spheres(request, predictor, format);
    return 0;
  }
  const std::vector<ImagePrediction> predictions =
      predict_images(predictor, pictures(request.images), request.options);
  std::cout << report(predictions);
  if (!request.json.empty()) write_json(request.json, to_json(predictions));
  for (const ImagePrediction& p : predictions) {
    if (!p.certified) continue;
    const std::string name = p.file.stem().string() + "_" + usual_file_name(format);
    if (!request.cameras.empty())
      write_calibration(fs::path(request.cameras) / name, format, std::vector{p.certified->camera});
    if (!request.undistorted.empty()) write_undistorted(p, request.undistorted);
  }
  return 0;
}

}  // namespace cps
