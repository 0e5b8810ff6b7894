#include "distortion/models/conversion/convert.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "apps/lens/report.h"
#include "apps/lens/verbs.h"
#include "apps/options.h"
#include "dataset/exchange/model_calibration.h"
#include "numbers/angles.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

struct ConvertRequest {
  std::string file, family, camera, size, held, format = "cps";
  fs::path output;
  std::optional<double> max_residual_px;
};

po::options_description describe(ConvertRequest& request) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("file", po::value(&request.file)->value_name("FILE")->required(),
      "the calibration; its name alone will do, without --file");
  add("to", po::value(&request.family)->value_name("FAMILY")->required(),
      "family of the new lens: brown_conrady, rational, kannala_brandt, unified_spherical, eucm or "
      "double_sphere");
  add("out,o", path_value(request.output)->required(), "the calibration to write");
  add("format", po::value(&request.format)->value_name("FORMAT")->default_value(request.format),
      "format of the new calibration: cps, opencv-yaml, opencv-xml, colmap, ros, kitti, kalibr, nerfstudio");
  add("camera", po::value(&request.camera)->value_name("NAME"),
      "name of the camera to convert [all cameras of the file]");
  add("size", po::value(&request.size)->value_name("WxH"),
      "WIDTHxHEIGHT of the pictures, for files that do not say it");
  add("hold", po::value(&request.held)->value_name("LIST"),
      "parameters of the new lens that keep these values, NAME=NUMBER separated by commas [none]");
  add("max-residual", po::value<double>(),
      "largest reprojection error to accept, pixels [any]; above it nothing is written");
  return options;
}

/// "k1=0,k2=0" as numbers by name, which the family must know.
std::map<std::string, double> held_parameters(const ConvertRequest& request) {
  std::map<std::string, double> held;
  for (std::size_t start = 0; start < request.held.size();) {
    const std::size_t end = std::min(request.held.find(',', start), request.held.size());
    const std::string part = request.held.substr(start, end - start);
    const std::size_t equals = part.find('=');
    if (equals == part.npos) throw po::error("--hold: '" + part + "' must be a name, = and a number");
    held[part.substr(0, equals)] = flag_value<double>("hold", part.substr(equals + 1));
    start = end + 1;
  }
  try {
    lens_from_parameters(request.family, held);
  } catch (const std::runtime_error& error) {
    throw po::error(std::string("--hold: ") + error.what());
  }
  return held;
}

CalibrationFormat output_format(const ConvertRequest& request) {
  try {
    return calibration_format_from_string(request.format);
  } catch (const std::runtime_error& error) {
    throw po::error(std::string("--") + error.what());
  }
}

void check(const ConvertRequest& request) {
  const auto families = family_names();
  if (std::find(families.begin(), families.end(), request.family) == families.end())
    throw po::error(fmt::format("--to: '{}' is none of {}", request.family, fmt::join(families, ", ")));
  if (request.max_residual_px && !(*request.max_residual_px >= 0))
    throw po::error("--max-residual: must be 0 or more pixels");
}

std::vector<ModelCamera> read_cameras(const ConvertRequest& request) {
  const ImageSize size = request.size.empty() ? ImageSize{0, 0} : flag_value<ImageSize>("size", request.size);
  if (!request.camera.empty()) return {read_model_camera(request.file, request.camera, size)};
  ModelCalibrationFile read = read_model_calibration_file(request.file, size);
  if (!read.unread.empty()) throw std::runtime_error(read.unread.front().fault);
  return std::move(read.cameras);
}

/// Throws std::runtime_error in one line if there is no such camera, or none that is close enough.
ConvertedCamera converted(const ModelCamera& camera, const ConvertRequest& request,
                          const std::map<std::string, double>& held) {
  ConvertedCamera result = convert(camera, request.family, held);
  const std::string where = request.file + ": camera " + camera.name + ": ";
  if (!result.why.empty()) throw std::runtime_error(where + result.why);
  if (request.max_residual_px && !(result.worst_px <= *request.max_residual_px))
    throw std::runtime_error(
        fmt::format("{}the closest {} lens is {:.3g} px off at worst, more than "
                    "--max-residual {}",
                    where, request.family, result.worst_px, *request.max_residual_px));
  return result;
}

}  // namespace

const Manual lens_convert_manual{
    .name = "cps lens convert",
    .summary = "fit a lens of another family to a calibration",
    .synopsis = {"CALIBRATION --to FAMILY [--camera NAME] [--size WxH] [--hold LIST] "
                 "[--max-residual PX] [--format FORMAT] -o FILE"},
    .description = R"(
Finds the camera of another lens family whose pixels show the same rays as nearly
as possible, proves it one-to-one on its frame, and writes it as a calibration.
Prints how far both cameras are apart: reprojection errors (rms and worst, in
pixels), the largest angle between the rays of one pixel, and the share of the
rays that the new camera shows as well.

Radially symmetric families have no place for tangential terms; what they leave
is part of the error. A lens that the family contains is converted exactly, such
as Brown-Conrady to rational.
)",
    .examples =
        {{"cps lens convert camera.yml --to eucm -o eucm.json", "fits an EUCM camera"},
         {"cps lens convert camera.yml --to unified_spherical --hold k1=0,k2=0,k3=0,p1=0,p2=0 -o xi.json",
          "fits a camera with xi as its only distortion"}},
    .see_also = {"cps lens", "cps lens check"},
};

int cps_lens_convert(const Arguments& arguments) {
  ConvertRequest request;
  const po::options_description options = describe(request);
  po::positional_options_description positional;
  positional.add("file", 1);
  po::variables_map values;
  if (!parse_options(arguments, lens_convert_manual, options, positional, values)) return 0;
  po::notify(values);
  if (values.count("max-residual")) request.max_residual_px = values["max-residual"].as<double>();
  check(request);
  const CalibrationFormat format = output_format(request);
  const auto held = held_parameters(request);
  std::error_code error;
  if (fs::equivalent(request.file, request.output, error))
    throw std::runtime_error(request.output.string() + ": would replace the calibration that is read");

  std::vector<ConvertedCamera> results;
  std::vector<ModelCamera> cameras;
  for (const ModelCamera& camera : read_cameras(request)) {
    results.push_back(converted(camera, request, held));
    cameras.push_back(results.back().camera);
  }
  write_model_calibration(request.output, format, cameras);
  for (const ConvertedCamera& result : results) {
    print_camera(result.camera);
    print_line("residual", fmt::format("rms {:.3g} px, worst {:.3g} px; rays at most {:.3g} degrees apart",
                                       result.rms_px, result.worst_px, degrees(result.worst_angle_rad)));
    print_line("covered", fmt::format("{:.2f} % of the rays", 100 * result.covered));
  }
  return 0;
}

}  // namespace cps
