#include <filesystem>
#include <iostream>
#include <variant>

#include "apps/options.h"
#include "apps/train/model_folder.h"
#include "apps/train/summaries.h"
#include "apps/train/usage.h"
#include "apps/train/verbs.h"
#include "dataset/exchange/model_calibration.h"
#include "files/files.h"
#include "trainer/evaluation/evaluate.h"
#include "trainer/evaluation/evaluate_rays.h"
#include "trainer/network/threads.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

struct EvalRequest {
  std::string model, data, part = "test", kitti, pictures, lens, camera, out, device = "cpu";
  int threads = 0;
  EvaluationOptions options;
};

po::options_description describe(EvalRequest& r) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("model", po::value(&r.model)->value_name("MODEL"), "model folder [the reference model]");
  add("data", po::value(&r.data)->value_name("DATASET"), "dataset folder");
  add("part", po::value(&r.part)->value_name("PART")->default_value(r.part),
      "part of the dataset: train, val or test");
  add("kitti", po::value(&r.kitti)->value_name("FOLDER"),
      "instead of --data: folder of KITTI raw data, not rectified, with calib_cam_to_cam.txt");
  add("pictures", po::value(&r.pictures)->value_name("FOLDER"),
      "instead of --data: folder of pictures taken by one camera, with --lens");
  add("lens", po::value(&r.lens)->value_name("FILE"),
      "calibration file for --pictures, in any format that cps lens check reads");
  add("camera", po::value(&r.camera)->value_name("NAME"), "name of the camera in the --lens file");
  add("robustness", po::bool_switch(&r.options.robustness),
      "also measure on blurred, noisy and otherwise corrupted images");
  add("per-camera", po::bool_switch(&r.options.per_camera),
      "also join the pictures of each camera, and measure what they say together (a model with --head fit)");
  add("bootstrap", po::value(&r.options.resamples)->default_value(r.options.resamples),
      "bootstrap resamples for the 95 % intervals; 0: no intervals");
  add("seed", po::value(&r.options.seed)->default_value(r.options.seed),
      "seed of the bootstrap and of the added noise");
  add("skip-bad-images", po::bool_switch(&r.options.skip_bad_images),
      "leave out images that cannot be read, and name them, instead of stopping");
  add("device", po::value(&r.device)->value_name("DEVICE")->default_value(r.device),
      "where to compute: cpu or cuda");
  add("threads", po::value(&r.threads)->default_value(r.threads), "number of threads; 0 means one per core");
  add("out,o", po::value(&r.out)->value_name("FILE"),
      "JSON file with all results; an HTML page is written beside it [eval.json, eval_kitti.json or eval_pictures.json in MODEL; without --model, in the working folder]");
  return options;
}

/// Pictures of Brown–Conrady cameras alone, or of any.
using AnySet = std::variant<EvaluationSet, RaySet>;

AnySet set_of(const EvalRequest& r) {
  if ((!r.data.empty()) + (!r.kitti.empty()) + (!r.pictures.empty()) != 1)
    throw po::error("give exactly one of --data, --kitti, --pictures");
  if (!r.kitti.empty()) return kitti_evaluation_set(r.kitti);
  if (!r.pictures.empty()) {
    if (r.lens.empty()) throw po::error("--pictures needs the camera's calibration: add --lens FILE");
    const ModelCamera camera = read_model_camera(r.lens, r.camera);
    const auto* lens = std::get_if<Distortion>(&camera.lens);
    if (!lens) return ray_set(r.pictures, camera);
    return picture_evaluation_set(r.pictures, {camera.name, camera.pinhole, *lens});
  }
  const Part part = usage_checked([&] { return part_from_string(r.part); });
  if (part == Part::all) throw po::error("--part: use train, val or test");
  const Dataset dataset = read_dataset(r.data, LensFamilies::any);
  if (is_brown_conrady(dataset, part)) return evaluation_set(dataset, part);
  return ray_set(dataset, part);
}

/// Beside the model that was named. Who uses the reference model need not be allowed to write where it is
/// installed: then it is a file of the working folder.
fs::path output_file(const EvalRequest& r) {
  if (!r.out.empty()) return r.out;
  return fs::path(r.model) / (!r.kitti.empty()      ? "eval_kitti.json"
                              : !r.pictures.empty() ? "eval_pictures.json"
                                                    : "eval.json");
}

template <typename Result>
void write_results(const EvalRequest& request, const fs::path& model, Result& result) {
  result.model = model.string();
  const fs::path json = output_file(request), page = fs::path(json).replace_extension(".html");
  write_json(json, to_json(result));
  write_file(page, to_html(result));
  std::cout << result.report() << "written to " << json.string() << " and " << page.string() << "\n";
}

}  // namespace

const Manual eval_manual{
    .name = "cps eval",
    .summary = eval_line.text,
    .synopsis = {"[--model MODEL] (--data DATASET | --kitti FOLDER | --pictures FOLDER --lens CALIBRATION)"},
    .description = R"(
Measures the errors of a trained network beside those of two baselines that
ignore the image. Prints a table and writes a JSON file and an HTML page.

Without --model it is the reference model that cps predict uses.

Networks and pictures may be of different lens families. They are compared in
ray space: the angle between the true and the predicted ray of a pixel, as it
is and after the best turn, the reprojection error, and the error of the H-FOV
that is seen. A Brown-Conrady network on pictures of such cameras has the
errors of its eight outputs, too.

--per-camera takes the pictures of each camera together, as cps predict
--one-camera does, and compares the result with the mean error of the single
pictures. Cameras are those of KITTI, and each lens of a dataset.
)",
    .examples = {{"cps eval --data data --model model", "measures on the test images of a dataset"},
                 {"cps eval --kitti kitti/2011_09_26 --model model", "measures on KITTI's raw pictures"},
                 {"cps eval --kitti kitti/2011_09_26 --model model --per-camera",
                  "also joins the frames of each of KITTI's cameras"}},
    .see_also = {"cps train", "cps predict", "cps relens"},
};

int eval_verb(const Arguments& arguments) {
  EvalRequest request;
  po::variables_map values;
  if (!parse_options(arguments, eval_manual, describe(request), {}, values)) return 0;
  po::notify(values);
  if (const std::string fault = request.options.fault(); !fault.empty()) throw po::error(fault);
  const Device device = usage_checked([&] { return device_from_string(request.device); });
  use_threads(request.threads);

  const fs::path model = model_folder_of(values);
  const Predictor predictor(model, device);
  if (request.options.per_camera && !is_fit(predictor.card().options.head))
    throw po::error("--per-camera: needs a model that was trained with --head fit");
  const AnySet set = set_of(request);
  const auto* of_brown_conrady = std::get_if<EvaluationSet>(&set);
  if (of_brown_conrady && !is_deepcalib(predictor.card().options.head)) {
    Evaluation evaluation = evaluate(predictor, *of_brown_conrady, request.options);
    write_results(request, model, evaluation);
    return 0;
  }
  if (request.options.robustness)
    throw po::error("--robustness: needs a Brown-Conrady network and pictures of Brown-Conrady cameras");
  if (request.options.per_camera) throw po::error("--per-camera: needs pictures of Brown-Conrady cameras");
  RayEvaluation evaluation = evaluate_rays(
      predictor, of_brown_conrady ? ray_set(*of_brown_conrady) : std::get<RaySet>(set), request.options);
  write_results(request, model, evaluation);
  return 0;
}

}  // namespace cps
