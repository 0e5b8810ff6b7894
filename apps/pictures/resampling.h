#pragma once

#include <boost/program_options.hpp>
#include <functional>
#include <string>

#include "apps/pictures/picture_file.h"
#include "apps/pictures/picture_jobs.h"
#include "dataset/exchange/model_calibration.h"
#include "distortion/warp/warp.h"

/// Options and files that `cps distort` and `cps undistort` share.
namespace cps {

struct ResamplingRequest {
  std::string input, output;
  std::string lens_file, lens_camera;
  std::string source_file;  ///< calibration of the input, when it is another file than the lens
  std::string size;         ///< WxH, or empty
  std::string resampling = "footprint", encoding = "auto";
  std::string label_format = "cps", label_file;
  std::string valid_file;  ///< mask of the pixels that the input shows; may be empty
  double sigma_px = 0.5;
};

/// The options of all members, with their help texts.
boost::program_options::options_description describe(ResamplingRequest& request);

/// Throws boost::program_options::error, one line naming the option, for values that their type allows but
/// that make no sense.
void check(const ResamplingRequest& request);

Resampling resampling_of(const ResamplingRequest& request);

/// The upright size of the first picture whose header can be read. Throws std::runtime_error if there is
/// none.
ImageSize first_size(const std::vector<PictureJob>& jobs);

/// The file for the label: --label, else in the output folder with the usual name of its format, or, for one
/// picture, beside it as PICTURE_NAME.
std::filesystem::path label_path(const ResamplingRequest& request, const std::vector<PictureJob>& jobs);

/// How the request's pictures are resampled, at their own resolution; a coarse one is not refused.
WarpOptions warp_options(const ResamplingRequest& request);

/// Resamples every picture, which must have the size of `source`, writes the label of `output` and, if the
/// request names one, the mask, and prints what was written, with `remark` after the H-FOV (of families other
/// than Brown–Conrady: the angle really shown). Pictures that fail are named on stderr; the others are
/// written. Returns the exit status: 1 if a picture failed. Throws std::runtime_error when the label cannot
/// be written, before any work if its format cannot hold the lens' family.
int resample_pictures(const ResamplingRequest& request, const std::vector<PictureJob>& jobs,
                      const ModelCamera& source, const ModelCamera& output, const std::string& remark,
                      const std::function<OIIO::ImageBuf(const OIIO::ImageBuf&)>& resample);

}  // namespace cps
