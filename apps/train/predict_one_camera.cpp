#include "apps/train/predict_one_camera.h"

#include <boost/program_options/errors.hpp>
#include <iostream>

#include "apps/train/camera_files.h"
#include "files/files.h"
#include "trainer/evaluation/one_camera_prediction.h"

namespace cps {

void predict_all_as_one_camera(const Predictor& predictor, const OneCameraRequest& request) {
  if (!is_fit(predictor.card().options.head))
    throw boost::program_options::error("--one-camera: needs a model that was trained with --head fit");
  const OneCameraPrediction prediction = predict_one_camera(predictor, request.pictures, request.options);
  std::cout << report(prediction);
  if (!request.cameras.empty()) {
    ModelCamera camera = model_camera(prediction.camera.certified.camera);
    camera.name = "camera";
    write_camera_files(request.cameras, "", request.formats, camera);
  }
  std::filesystem::path json = request.json;
  if (json.empty() && !request.cameras.empty()) json = request.cameras / "one_camera.json";
  if (json.empty()) return;
  const std::filesystem::path plot = std::filesystem::path(json).replace_extension(".svg");
  write_json(json, to_json(prediction));
  write_file(plot, convergence_svg(prediction));
  std::cout << "written to " << json.string() << " and " << plot.string() << "\n";
}

}  // namespace cps
