#include <fmt/format.h>

#include <stdexcept>

#include "apps/options.h"
#include "apps/pictures/resampling.h"
#include "apps/threads.h"
#include "apps/verbs.h"
#include "distortion/certificate/frame_certificate.h"
#include "distortion/models/warp/model_view.h"
#include "distortion/models/warp/warp_models.h"
#include "numbers/angles.h"

namespace po = boost::program_options;

namespace cps {
namespace {

struct UndistortRequest : ResamplingRequest {
  std::string keep = "valid";
  double hfov_deg = 0;  ///< H-FOV of the output; 0: as `keep` says
  bool rescale = false;
};

po::options_description describe_all(UndistortRequest& request) {
  po::options_description options = describe(request);
  auto add = options.add_options();
  add("keep", po::value(&request.keep)->value_name("WORD")->default_value(request.keep),
      "what the output shows: valid, the widest view without black; all, everything the input shows, with "
      "black around it; camera, the view of the calibration's own matrix, as OpenCV's undistort");
  add("hfov", po::value(&request.hfov_deg),
      "instead of --keep: horizontal field of view of the output, degrees, 1 to 175");
  add("rescale", po::bool_switch(&request.rescale),
      "accept pictures of another size than the calibration's, and scale the calibration to them");
  add("valid", po::value(&request.valid_file)->value_name("FILE"),
      "also write which pixels of the output the input shows, as a .png: 255, or 0 where it is black");
  return options;
}

Keep keep_from_string(const std::string& word) {
  if (word == "valid") return Keep::valid;
  if (word == "all") return Keep::all;
  if (word == "camera") return Keep::camera;
  throw po::error("--keep " + word + ": is none of valid, all, camera");
}

void check_all(const UndistortRequest& request, const po::variables_map& values) {
  check(request);
  keep_from_string(request.keep);
  if (request.lens_file.empty()) throw po::error("name the lens: --lens FILE");
  if (values.count("hfov") && !values["keep"].defaulted()) throw po::error("choose --keep or --hfov");
  if (values.count("hfov") && !(request.hfov_deg >= 1 && request.hfov_deg <= 175))
    throw po::error("--hfov: must lie between 1 and 175 degrees");
}

ModelCamera source_camera(const UndistortRequest& request, const std::vector<PictureJob>& jobs) {
  const ModelCamera camera = read_model_camera(request.lens_file, request.lens_camera);
  if (!request.rescale) return camera;
  const ImageSize size = first_size(jobs);
  const Pinhole& own = camera.pinhole;
  const double expected_height = static_cast<double>(size.width) * own.height / own.width;
  if (std::abs(size.height - expected_height) > 1)
    throw std::runtime_error(fmt::format(
        "{}: --rescale: the calibration is for {} x {}, the pictures are {} x {}: another shape, so cropped "
        "or of another mode of the camera; calibrate that",
        request.lens_file, own.width, own.height, size.width, size.height));
  return resized(camera, size.width, size.height);
}

/// Throws std::runtime_error for a lens that is proved nowhere; names on stderr what is left black of one
/// that is not proved everywhere.
void require_proof(const UndistortRequest& request, bool is_usable, bool is_whole, const std::string& why) {
  if (!is_usable) throw std::runtime_error(request.lens_file + ": " + why);
  if (!is_whole) fmt::print(stderr, "{}: {}; the part beyond is left black\n", request.lens_file, why);
}

/// `Camera`: CalibratedCamera, whose pictures take the same way as ever, or ModelCamera.
template <typename Camera>
Pinhole output_camera(const UndistortRequest& request, const Camera& source) {
  const ImageSize size = request.size.empty() ? ImageSize{source.pinhole.width, source.pinhole.height}
                                              : picture_size("size", request.size);
  if (request.hfov_deg > 0) return pinhole_from_hfov(size.width, size.height, radians(request.hfov_deg));
  const ViewFit fit =
      fit_straight_view(source, keep_from_string(request.keep), size.width, size.height, request.sigma_px);
  if (!fit.valid) throw std::runtime_error(request.lens_file + ": " + fit.why);
  return fit.camera;
}

WarpOptions uncovered_options(const UndistortRequest& request) {
  WarpOptions options = warp_options(request);
  options.require_coverage = false;
  return options;
}

int straighten(const UndistortRequest& request, const std::vector<PictureJob>& jobs,
               const CalibratedCamera& source) {
  const FrameCertificate proof = certify_frame(source.distortion, source.pinhole, warpable);
  require_proof(request, proof.certificate.valid, proof.valid(), proof.why);
  const ModelCamera output{source.name, output_camera(request, source), Distortion{}};
  const WarpOptions options = uncovered_options(request);
  return resample_pictures(
      request, jobs, model_camera(source), output, "", [&](const OIIO::ImageBuf& distorted) {
        return unwarp(distorted, source.pinhole, source.distortion, output.pinhole, options);
      });
}

int straighten(const UndistortRequest& request, const std::vector<PictureJob>& jobs,
               const ModelCamera& source) {
  const ModelCertificate proof = certify_frame(source, warpable);
  require_proof(request, proof.region.max_angle_rad > 0, proof.valid, proof.why);
  const ModelCamera output{source.name, output_camera(request, source), Distortion{}};
  const WarpOptions options = uncovered_options(request);
  return resample_pictures(request, jobs, source, output, "", [&](const OIIO::ImageBuf& distorted) {
    return warp_between(distorted, source, output, options);
  });
}

}  // namespace

const Manual undistort_manual{
    .name = "cps undistort",
    .summary = "straighten pictures taken through a lens",
    .synopsis = {"INPUT -o OUTPUT --lens CALIBRATION [--keep valid|all|camera | --hfov DEG]"},
    .description = R"(
Removes the distortion of pictures and writes the label of the pinhole camera
that they then have: straight lines of the world become straight.

The output has square pixels and a centred principal point, except with --keep
camera. What the input does not show is black (0); --valid writes a mask of it.

The lens may be of any family that cps lens check reads. A fisheye shows more
than a straight picture can: --keep valid shows at most 160 degrees of it, and
--keep all is refused from 85 degrees off the axis on. --hfov chooses less.

Pixel type, channels and file format stay as they are. If pictures of a folder
fail, they are named, the others are written, and the exit status is 1.
)",
    .examples = {{"cps undistort photos/ -o straight/ --lens camera.yml", "straightens a folder of photos"},
                 {"cps undistort fisheye/ -o straight/ --lens fisheye.yml --hfov 110 --valid valid.png",
                  "straightens the middle of a fisheye's pictures, with a mask"}},
    .see_also = {"cps distort", "cps lens check"},
};

int cps_undistort(const Arguments& arguments) {
  UndistortRequest request;
  po::positional_options_description positional;
  positional.add("input", 1);
  po::variables_map values;
  if (!parse_options(arguments, undistort_manual, describe_all(request), positional, values)) return 0;
  po::notify(values);
  check_all(request, values);
  const ThreadLimit threads(values);

  const std::vector<PictureJob> jobs = picture_jobs(request.input, request.output);
  const ModelCamera source = source_camera(request, jobs);
  if (const auto* lens = std::get_if<Distortion>(&source.lens))
    return straighten(request, jobs, CalibratedCamera{source.name, source.pinhole, *lens});
  return straighten(request, jobs, source);
}

}  // namespace cps
