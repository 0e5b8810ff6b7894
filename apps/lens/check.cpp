#include <cstdio>
#include <iostream>

#include "apps/lens/report.h"
#include "apps/lens/verbs.h"
#include "apps/options.h"
#include "dataset/exchange/model_calibration.h"

namespace po = boost::program_options;

namespace cps {

const Manual lens_check_manual{
    .name = "cps lens check",
    .summary = "prove that a calibration is one-to-one",
    .synopsis = {"CALIBRATION [--camera NAME]"},
    .description = R"(
Proves that the lens of a calibration maps its whole frame one-to-one, or says
where it does not. Prints the true angles of view, how exactly the lens is
inverted and, for Brown-Conrady, where common iterative inverses fail on it.

Reads cps' calibration.json, OpenCV's YAML and XML, COLMAP's cameras.txt, ROS'
camera_info, KITTI's calib_cam_to_cam.txt, Kalibr's camchain, nerfstudio's
transforms.json and others, with Brown-Conrady, rational, Kannala-Brandt
(OpenCV's fisheye), unified spherical, EUCM or double sphere lenses.
)",
    .exit_status = {{"0", "every lens is one-to-one"},
                    {"1", "failed, or a lens is not one-to-one; stderr says why"},
                    {"2", "wrong usage"}},
    .examples = {{"cps lens check calib_cam_to_cam.txt --camera 00", "checks the first of KITTI's cameras"}},
    .see_also = {"cps lens", "cps lens convert"},
};

int cps_lens_check(const Arguments& arguments) {
  std::string file, camera, size;
  po::options_description options("Options");
  options.add_options()("file", po::value(&file)->value_name("FILE")->required(),
                        "the calibration; its name alone will do, without --file")(
      "camera", po::value(&camera)->value_name("NAME"),
      "name of the camera to check [all cameras of the file]")(
      "size", po::value(&size)->value_name("WxH"),
      "WIDTHxHEIGHT of the pictures, for files that do not say it");
  po::positional_options_description positional;
  positional.add("file", 1);
  po::variables_map values;
  if (!parse_options(arguments, lens_check_manual, options, positional, values)) return 0;
  po::notify(values);
  const ImageSize pictures = size.empty() ? ImageSize{0, 0} : flag_value<ImageSize>("size", size);
  const ModelCalibrationFile read =
      camera.empty() ? read_model_calibration_file(file, pictures)
                     : ModelCalibrationFile{{read_model_camera(file, camera, pictures)}, {}};
  bool all_valid = read.unread.empty();
  for (const UnreadCamera& unread : read.unread) std::cerr << "cps: " << unread.fault << "\n";
  for (const ModelCamera& calibrated : read.cameras) {
    const std::string why = check_camera(calibrated);
    std::fflush(stdout);
    if (why.empty()) continue;
    std::cerr << "cps: " << file << ": camera " << calibrated.name << ": " << why << "\n";
    all_valid = false;
  }
  return all_valid ? 0 : 1;
}

}  // namespace cps
