#include <filesystem>
#include <iostream>

#include "apps/options.h"
#include "apps/train/usage.h"
#include "apps/train/verbs.h"
#include "dataset/exchange/calibration_file.h"
#include "files/files.h"
#include "trainer/evaluation/evaluate.h"
#include "trainer/network/threads.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

struct Request {
  std::string model, data, part = "test", kitti, pictures, lens, camera, out, device = "cpu";
  int threads = 0;
  EvaluationOptions options;
};

po::options_description describe(Request& r) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("model", po::value(&r.model)->required(), "the model's folder");
  add("data", po::value(&r.data), "a dataset's folder");
  add("part", po::value(&r.part)->default_value(r.part), "of the dataset: train, val or test");
  add("kitti", po::value(&r.kitti),
      "or a folder of KITTI raw data, not rectified, with calib_cam_to_cam.txt");
  add("pictures", po::value(&r.pictures), "or a folder of pictures of one camera, with --lens");
  add("lens", po::value(&r.lens), "its calibration, in any format that cps lens check reads");
  add("camera", po::value(&r.camera), "which of the file's cameras, by name");
  add("robustness", po::bool_switch(&r.options.robustness), "measure again with blurred, noisy … images");
  add("bootstrap", po::value(&r.options.resamples)->default_value(r.options.resamples),
      "resamples for the 95 % intervals; 0: none");
  add("seed", po::value(&r.options.seed)->default_value(r.options.seed), "of bootstrap and noise");
  add("skip-bad-images", po::bool_switch(&r.options.skip_bad_images),
      "leave out what cannot be read, and say so, instead of stopping");
  add("device", po::value(&r.device)->default_value(r.device), "cpu or cuda");
  add("threads", po::value(&r.threads)->default_value(r.threads), "0: all cores");
  add("out,o", po::value(&r.out), "everything as JSON; a page goes beside it [MODEL/eval.json, …]");
  return options;
}

EvaluationSet set_of(const Request& r) {
  if ((!r.data.empty()) + (!r.kitti.empty()) + (!r.pictures.empty()) != 1)
    throw po::error("say what to measure on: one of --data, --kitti, --pictures");
  if (!r.kitti.empty()) return kitti_evaluation_set(r.kitti);
  if (!r.pictures.empty()) {
    if (r.lens.empty()) throw po::error("--pictures needs the camera's calibration: --lens FILE");
    return picture_evaluation_set(r.pictures, chosen_camera(read_calibration(r.lens), r.camera, r.lens));
  }
  const Part part = usage_checked([&] { return part_from_string(r.part); });
  if (part == Part::all) throw po::error("--part: say train, val or test");
  return evaluation_set(read_dataset(r.data), part);
}

fs::path output_file(const Request& r) {
  if (!r.out.empty()) return r.out;
  return fs::path(r.model) / (!r.kitti.empty()      ? "eval_kitti.json"
                              : !r.pictures.empty() ? "eval_pictures.json"
                                                    : "eval.json");
}

}  // namespace

int eval_verb(const Arguments& arguments) {
  Request request;
  po::variables_map values;
  if (!parse_options(arguments,
                     "cps eval --model MODEL (--data DATASET | --kitti FOLDER | --pictures FOLDER --lens "
                     "FILE)\nErrors of "
                     "a trained network, beside those of two predictors that look at nothing; on screen, as "
                     "JSON and as a "
                     "page.\n",
                     describe(request), {}, values))
    return 0;
  po::notify(values);
  std::string why;
  if (!request.options.is_valid(&why)) throw po::error(why);
  const Device device = usage_checked([&] { return device_from_string(request.device); });
  use_threads(request.threads);

  const Predictor predictor(request.model, device);
  Evaluation evaluation = evaluate(predictor, set_of(request), request.options);
  evaluation.model = request.model;
  const fs::path json = output_file(request), page = fs::path(json).replace_extension(".html");
  write_json(json, to_json(evaluation));
  write_file(page, to_html(evaluation));
  std::cout << evaluation.report() << "written to " << json.string() << " and " << page.string() << "\n";
  return 0;
}

}  // namespace cps
