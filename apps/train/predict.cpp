#include "trainer/evaluation/predict.h"

#include <iostream>
#include <stdexcept>

#include "apps/options.h"
#include "apps/pictures/picture_file.h"
#include "apps/train/camera_files.h"
#include "apps/train/model_folder.h"
#include "apps/train/predict_one_camera.h"
#include "apps/train/summaries.h"
#include "apps/train/usage.h"
#include "apps/train/verbs.h"
#include "dataset/exchange/camera_pictures.h"
#include "dataset/exchange/model_calibration.h"
#include "distortion/warp/view_fit.h"
#include "files/files.h"
#include "trainer/evaluation/predict_spheres.h"
#include "trainer/model/half_model.h"
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
  bool one_camera = false;
  PredictOptions options;
  OneCameraOptions one_camera_options;
};

po::options_description describe(PredictRequest& r) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("model", po::value(&r.model)->value_name("MODEL"), "model folder [the reference model]");
  add("image", po::value(&r.images)->value_name("PATH"),
      "pictures, or folders of pictures; --image itself may be omitted");
  add("one-camera", po::bool_switch(&r.one_camera),
      "one camera took all the pictures: join what they say (a model with --head fit)");
  add("common-share",
      po::value(&r.one_camera_options.common_share)->default_value(r.one_camera_options.common_share),
      "with --one-camera: share of the variance of the directly read numbers that all pictures have in common");
  add("json", po::value(&r.json)->value_name("FILE"), "also write the predictions to this JSON file");
  add("cameras", po::value(&r.cameras)->value_name("FOLDER"),
      "folder for calibration files, one per picture, or with --one-camera one for all, with a certified lens");
  add("format", po::value(&r.format)->value_name("FORMAT")->default_value(r.format),
      "format of the calibration files: cps, opencv-yaml, opencv-xml, colmap, ros, kitti, kalibr, nerfstudio; "
      "all: each of them");
  add("undistort", po::value(&r.undistorted)->value_name("FOLDER"),
      "folder for undistorted pictures, made with the predicted lens and without black borders");
  add("export", po::value(&r.exported_as)->value_name("FORMAT"),
      "instead of predicting, write the network: onnx, a file for other programs, or half, a model folder "
      "with weights of half the size");
  add("out,o", po::value(&r.out)->value_name("PATH"),
      "file of --export onnx [model.onnx in MODEL; without --model, in the working folder], or folder of "
      "--export half");
  add("variants", po::value(&r.options.variants)->default_value(r.options.variants),
      "variants of each picture whose predictions give the spread; 0: no spread");
  add("device", po::value(&r.device)->value_name("DEVICE")->default_value(r.device),
      "where to compute: cpu or cuda");
  add("threads", po::value(&r.threads)->default_value(r.threads), "number of threads; 0 means one per core");
  return options;
}

/// Throws if options do not go with --one-camera, or need it.
void check_one_camera(const PredictRequest& r, const po::variables_map& values) {
  if (!r.one_camera) {
    if (!values["common-share"].defaulted()) throw po::error("--common-share: belongs to --one-camera");
    return;
  }
  refuse_flags_with(r.one_camera_options.fault());
  if (!values["variants"].defaulted())
    throw po::error("--variants: not with --one-camera, whose deviations take the place of the spread");
  if (!r.undistorted.empty())
    throw po::error(
        "--undistort: not with --one-camera: give cps undistort --lens the calibration that --cameras writes");
}

/// Throws if options are missing, or do not go together.
void check(const PredictRequest& r, const po::variables_map& values) {
  if (r.options.variants < 0 || r.options.variants > 1000)
    throw po::error("--variants: must lie in [0, 1000]");
  check_one_camera(r, values);
  if (r.exported_as.empty()) {
    if (r.images.empty()) throw po::error("name the pictures to predict, or --export onnx or half");
    if (!r.out.empty()) throw po::error("--out: belongs to --export; for predictions use --json FILE");
    return;
  }
  if (r.exported_as != "onnx" && r.exported_as != "half")
    throw po::error("--export " + r.exported_as + ": must be onnx or half");
  if (r.exported_as == "half" && r.out.empty())
    throw po::error("--export half: writes a model folder: name it by --out FOLDER");
  if (!r.images.empty() || !r.json.empty() || !r.cameras.empty() || !r.undistorted.empty() || r.one_camera)
    throw po::error(
        "--export: writes the network and predicts nothing: leave out pictures, --json, --cameras, "
        "--undistort and --one-camera");
}

void export_network(const PredictRequest& r, const fs::path& model) {
  // Without --out beside the model that was named, or in the working folder, as cps eval.
  const fs::path out = r.out.empty() ? fs::path(r.model) / onnx_file_name : fs::path(r.out);
  if (r.exported_as == "half")
    write_half_model(model, out);
  else
    write_onnx(model, out);
  std::cout << "written to " << out.string() << "\n";
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
                         const std::vector<CalibrationFormat>& formats) {
  if (!request.undistorted.empty())
    throw po::error("--undistort: a deepcalib model writes --cameras, which cps undistort --lens takes");
  const LensModel family = UnifiedSpherical{};
  if (!request.cameras.empty() && formats.size() == 1 && !can_hold(formats.front(), family))
    throw po::error("--format " + to_string(formats.front()) +
                    ": cannot hold the unified_spherical lenses of a deepcalib model; cps, opencv-yaml, "
                    "opencv-xml and kalibr can");
  const std::vector<SpherePrediction> predictions = predict_spheres(predictor, pictures(request.images));
  std::cout << report(predictions);
  if (!request.json.empty()) write_json(request.json, to_json(predictions));
  if (request.cameras.empty()) return;
  for (const SpherePrediction& p : predictions)
    write_camera_files(request.cameras, p.file.stem().string() + "_", formats, p.camera);
}

}  // namespace

const Manual predict_manual{
    .name = "cps predict",
    .summary = predict_line.text,
    .synopsis = {"[--model MODEL] [--json FILE] [--cameras FOLDER] [--undistort FOLDER] IMAGE...",
                 "[--model MODEL] --one-camera [--json FILE] [--cameras FOLDER] IMAGE...",
                 "[--model MODEL] --export onnx [-o FILE]", "[--model MODEL] --export half -o FOLDER"},
    .description = R"(
Runs a trained network on pictures: prints H-FOV, distortion and principal
point, and the true values if a calibration.json lies beside the picture.

Without --model it uses the reference model: the folder cps-reference in the
folder that the environment variable CPS_MODEL_DIR names, or else in
share/cps/models of the installation.

Calibration files and undistorted pictures use a certified lens: if the
predicted one is not certified, its distortion is reduced until it is.

A model of a deepcalib preset prints the focal length and xi of a
unified_spherical camera, and its errors against the truth in ray space; there
is no spread and no --undistort.

The second form takes the pictures as those of one camera, all of one size, as a
dash camera makes them, and finds the lens that fits all of them best; the
camera may point elsewhere in each. Pictures and edges that do not agree with
the rest, such as those of moving cars, count less. It prints the numbers with
their standard deviations, and how many pictures agree. With --json or
--cameras it also writes them as JSON (one_camera.json in the folder of
--cameras), with a plot beside it that shows how the numbers settle with more
pictures. The model must have been trained with --head fit.

The other forms predict nothing. The third writes the network as a file that
other programs can run; its metadata say what its inputs and outputs are. The
fourth writes a copy of the model folder whose weights are rounded to float16.
It is for handing on a model; predictions with it are computed in float32, too.
)",
    .examples = {{"cps predict photo.jpg", "prints what the reference model sees in one picture"},
                 {"cps predict --model model photo.jpg", "the same of a model of yours"},
                 {"cps predict --model model --cameras cameras --undistort straight photos",
                  "writes a calibration file and a straightened picture for each one of a folder"},
                 {"cps predict --model model --one-camera --cameras camera --format all frames",
                  "finds the lens of a dash camera from its frames, and writes it in every format"},
                 {"cps predict --model model --export onnx -o lens.onnx",
                  "writes the network for ONNX Runtime and its like"},
                 {"cps predict --model model --export half -o small",
                  "writes a copy of the model of half the size"}},
    .see_also = {"cps train", "cps eval", "cps undistort"},
};

int predict_verb(const Arguments& arguments) {
  PredictRequest request;
  po::positional_options_description positional;
  positional.add("image", -1);
  po::variables_map values;
  if (!parse_options(arguments, predict_manual, describe(request), positional, values)) return 0;
  po::notify(values);
  check(request, values);
  const std::vector<CalibrationFormat> formats =
      usage_checked([&] { return formats_of_word(request.format); });
  const Device device = usage_checked([&] { return device_from_string(request.device); });
  const fs::path model = model_folder_of(values);
  if (!request.exported_as.empty()) {
    export_network(request, model);
    return 0;
  }
  use_threads(request.threads);

  const Predictor predictor(model, device);
  if (request.one_camera) {
    predict_all_as_one_camera(predictor, {pictures(request.images), request.cameras, request.json, formats,
                                          request.one_camera_options});
    return 0;
  }
  if (is_deepcalib(predictor.card().options.head)) {
    predict_all_spheres(request, predictor, formats);
    return 0;
  }
  const std::vector<ImagePrediction> predictions =
      predict_images(predictor, pictures(request.images), request.options);
  std::cout << report(predictions);
  if (!request.json.empty()) write_json(request.json, to_json(predictions));
  for (const ImagePrediction& p : predictions) {
    if (!p.certified) continue;
    if (!request.cameras.empty())
      write_camera_files(request.cameras, p.file.stem().string() + "_", formats,
                         model_camera(p.certified->camera));
    if (!request.undistorted.empty()) write_undistorted(p, request.undistorted);
  }
  return 0;
}

}  // namespace cps
