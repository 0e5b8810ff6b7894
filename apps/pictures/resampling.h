#pragma once

#include <boost/program_options.hpp>
#include <string>

#include "apps/pictures/picture_file.h"
#include "apps/pictures/picture_jobs.h"
#include "dataset/exchange/calibration_file.h"
#include "distortion/warp/warp.h"

/// What `cps distort` and `cps undistort` have in common.
namespace cps {

struct ResamplingRequest {
  std::string input, output;
  std::string lens_file, lens_camera;
  std::string size;  ///< WxH, or empty
  std::string resampling = "footprint", encoding = "auto";
  std::string label_format = "cps", label_file;
  double sigma_px = 0.5;
};

/// The flags of all members, with their help.
boost::program_options::options_description describe(ResamplingRequest& request);

/// Throws boost::program_options::error for what the flags' own types do not rule out.
void check(const ResamplingRequest& request);

Resampling resampling_of(const ResamplingRequest& request);

/// The size of the first picture whose header can be read. Throws std::runtime_error if there is none.
Eigen::Vector2i first_size(const std::vector<PictureJob>& jobs);

/// Where the label goes: beside the pictures of a folder under the name that its format goes by, or beside
/// the one picture under its name.
std::filesystem::path label_path(const ResamplingRequest& request, const std::vector<PictureJob>& jobs);

}  // namespace cps
