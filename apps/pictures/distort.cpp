#include <fmt/format.h>

#include <iostream>
#include <stdexcept>

#include "apps/options.h"
#include "apps/pictures/resampling.h"
#include "apps/threads.h"
#include "apps/verbs.h"
#include "distortion/certificate/frame_certificate.h"
#include "distortion/models/warp/model_view.h"
#include "distortion/models/warp/source_resolution.h"
#include "distortion/models/warp/warp_models.h"
#include "distortion/warp/master_camera.h"
#include "numbers/angles.h"
#include "sampler/lenses/lens_draw.h"
#include "sampler/recipe/lens_keys.h"

namespace po = boost::program_options;

namespace cps {
namespace {

struct DistortRequest : ResamplingRequest {
  double hfov_deg = 0;  ///< H-FOV of the pictures; 0: read from `source_file`
  std::string scheme;   ///< how to draw the lens; empty: it is read from `lens_file`
  std::uint64_t seed = 0;
  int number = 1;
  LensOptions lenses;
  bool require_resolution = false;
};

/// The keys for the crop and for drawn lenses, except lens_draw, which is an option without a default here.
template <typename Visitor>
void for_each_draw_key(LensOptions& lenses, Visitor visit) {
  for_each_lens_key(lenses, [&](const char* key, auto& member, const char* help) {
    if (std::string_view(key) != "lens_draw") visit(key, member, help);
  });
}

po::options_description describe_all(DistortRequest& request) {
  po::options_description options = describe(request);
  auto add = options.add_options();
  add("hfov", po::value(&request.hfov_deg), "horizontal field of view of the input, degrees, 1 to 175");
  add("source", po::value(&request.source_file)->value_name("FILE"),
      "instead of --hfov: file with the calibration of the input: without distortion, or a fisheye's, whose "
      "pictures go from lens to lens at once");
  add("lens_draw", po::value(&request.scheme)->value_name("SCHEME"),
      "instead of --lens: draw the lens, by sequential, shape_prior or real_lenses");
  add("seed", po::value(&request.seed)->default_value(request.seed), "seed of a drawn lens");
  add("number", po::value(&request.number)->default_value(request.number),
      "number of a drawn lens in the list that cps lens sample prints for the seed, from 1");
  add("require-resolution", po::bool_switch(&request.require_resolution),
      "fail if the input is too coarse for the filter, instead of widening the filter where it is");
  options.add(
      key_options("Crop and drawn lenses", [&](auto visit) { for_each_draw_key(request.lenses, visit); }));
  return options;
}

void check_all(DistortRequest& request, const po::variables_map& values) {
  check(request);
  if (request.lens_file.empty() == request.scheme.empty())
    throw po::error("name the lens: either --lens FILE or --lens_draw SCHEME");
  if ((values.count("hfov") > 0) == !request.source_file.empty())
    throw po::error("say what the input is: either --hfov DEG or --source FILE");
  if (values.count("hfov") && !(request.hfov_deg >= 1 && request.hfov_deg <= 175))
    throw po::error("--hfov: must lie between 1 and 175 degrees");
  if (request.number < 1) throw po::error("--number: must be at least 1");
  read_key_flags(values, [&](auto visit) { for_each_draw_key(request.lenses, visit); });
  if (!request.scheme.empty()) request.lenses.scheme = flag_value<LensScheme>("lens_draw", request.scheme);
  refuse_flags_with(request.lenses.fault());
}

/// The camera that took the input: without a lens, or with one of a family other than Brown–Conrady.
ModelCamera source_camera(const DistortRequest& request, const std::vector<PictureJob>& jobs) {
  if (request.source_file.empty()) {
    const ImageSize size = first_size(jobs);
    return {"", pinhole_from_hfov(size.width, size.height, radians(request.hfov_deg)), Distortion{}};
  }
  const ModelCamera source = read_model_camera(request.source_file, "");
  const auto* lens = std::get_if<Distortion>(&source.lens);
  if (lens && *lens != Distortion{})
    throw std::runtime_error(request.source_file +
                             ": k1 k2 p1 p2 k3: are not 0; straighten the input first (cps undistort)");
  if (!lens && !request.scheme.empty())
    throw std::runtime_error(fmt::format(
        "{}: is a {} lens: --lens_draw needs an input without one; straighten it first (cps undistort)",
        request.source_file, family_name(source.lens)));
  return source;
}

/// The camera that the output shall look as if taken by, before any zoom.
ModelCamera wanted_camera(const DistortRequest& request, const Pinhole& source) {
  const ImageSize size =
      request.size.empty() ? ImageSize{source.width, source.height} : picture_size("size", request.size);
  if (!request.lens_file.empty()) {
    const ModelCamera camera = read_model_camera(request.lens_file, request.lens_camera);
    return request.size.empty() ? camera : resized(camera, size.width, size.height);
  }
  const Pinhole base = pinhole_from_hfov(size.width, size.height, hfov_rad(source));
  const DrawnLens lens = draw_lens(base, CropOrder::base_first, request.lenses,
                                   substream(make_stream(request.seed, "lens"), request.number));
  return {"drawn", lens.crop.camera, lens.distortion};
}

/// Warns on stderr, or throws std::runtime_error with --require-resolution, if the input is too coarse for
/// the filter: `min_source_px` is the number of source pixels per axis of an output pixel where the lens
/// enlarges most.
void report_resolution(const DistortRequest& request, double min_source_px) {
  const double needed = 1 / largest_magnification({.oversampling = 1, .kernel_sigma_px = request.sigma_px});
  if (resampling_of(request) != Resampling::footprint || min_source_px >= needed) return;
  const std::string line = fmt::format(
      "{}: where the lens enlarges most, an output pixel has {:.3g} source pixels per axis, but its filter "
      "needs {:.3g}: use a finer source, or --sigma {:.2g}",
      request.input, min_source_px, needed, request.sigma_px * needed / min_source_px + 0.005);
  if (request.require_resolution) throw std::runtime_error(line);
  std::cerr << line << "; the filter is widened there\n";
}

std::string zoom_remark(const ViewFit& fit, double unzoomed) {
  return fmt::format(", zoom {:.4f}", fit.camera.fx / unzoomed);
}

void require_fit(const DistortRequest& request, const ViewFit& fit) {
  if (!fit.valid) throw std::runtime_error(request.input + ": " + fit.why);
}

/// An input without a lens, shown through a Brown–Conrady lens.
int bend(const DistortRequest& request, const std::vector<PictureJob>& jobs, const Pinhole& source,
         CalibratedCamera output) {
  const double unzoomed = output.pinhole.fx;
  const ViewFit fit =
      fit_distorted_view(source, output, request.sigma_px, request.lenses.principal_point.max_zoom);
  require_fit(request, fit);
  output.pinhole = fit.camera;
  const FrameCertificate proof = certify_frame(output.distortion, output.pinhole, warpable);
  if (!proof.valid()) throw std::runtime_error(request.lens_file + ": " + proof.why);
  report_resolution(request, std::min(source.fx / fit.camera.fx, source.fy / fit.camera.fy) /
                                 proof.certificate.max_eigenvalue);

  const WarpOptions options = warp_options(request);
  return resample_pictures(request, jobs, {"", source, Distortion{}}, model_camera(output),
                           zoom_remark(fit, unzoomed), [&](const OIIO::ImageBuf& ideal) {
                             return warp(ideal, source, output.distortion, output.pinhole, options);
                           });
}

/// Any other pair of lenses.
int bend(const DistortRequest& request, const std::vector<PictureJob>& jobs, const ModelCamera& source,
         ModelCamera output) {
  const ModelCertificate source_proof = certify_frame(source, warpable);
  if (!(source_proof.region.max_angle_rad > 0))
    throw std::runtime_error(request.source_file + ": " + source_proof.why);
  const double unzoomed = output.pinhole.fx;
  const ViewFit fit =
      fit_distorted_view(source, output, request.sigma_px, request.lenses.principal_point.max_zoom);
  require_fit(request, fit);
  output.pinhole = fit.camera;
  const ModelCertificate proof = certify_frame(output, warpable);
  if (!proof.valid) throw std::runtime_error(request.lens_file + ": " + proof.why);
  report_resolution(request, fewest_source_px(source, source_proof.region, output, proof.region));

  const WarpOptions options = warp_options(request);
  return resample_pictures(
      request, jobs, source, output, zoom_remark(fit, unzoomed),
      [&](const OIIO::ImageBuf& picture) { return warp_between(picture, source, output, options); });
}

}  // namespace

const Manual distort_manual{
    .name = "cps distort",
    .summary = "show ideal pictures through a lens, with labels",
    .synopsis =
        {"INPUT -o OUTPUT (--lens CALIBRATION | --lens_draw SCHEME) (--hfov DEG | --source CALIBRATION) "
         "[--KEY VALUE ...]"},
    .description = R"(
Takes pictures without distortion, such as a simulator's, to pictures as the
lens would have taken them, and writes their label.

The output is what the camera of the calibration would have taken. Where that
camera sees more than the input shows, the output is zoomed in until it has no
black border; --max_zoom 1 forbids that. A drawn lens is cropped as by cps
generate. All pictures of a folder, with their ids and depth, get the same size,
lens and label. A source with twice the output's resolution keeps the sharpness
equal all over the picture. The lens may be of any family that cps lens check
reads.

Pixel type, channels and file format stay as they are. If pictures of a folder
fail, they are named, the others are written, and the exit status is 1.
)",
    .examples = {{"cps distort ideal/ -o seen/ --hfov 100 --lens camera.yml",
                  "shows a simulator's pictures as a calibrated camera sees them"},
                 {"cps distort ideal/ -o seen/ --hfov 100 --lens_draw shape_prior --seed 7",
                  "shows them through a drawn lens"}},
    .see_also = {"cps undistort", "cps lens check"},
};

int cps_distort(const Arguments& arguments) {
  DistortRequest request;
  po::positional_options_description positional;
  positional.add("input", 1);
  po::variables_map values;
  if (!parse_options(arguments, distort_manual, describe_all(request), positional, values)) return 0;
  po::notify(values);
  check_all(request, values);
  const ThreadLimit threads(values);

  const std::vector<PictureJob> jobs = picture_jobs(request.input, request.output);
  const ModelCamera source = source_camera(request, jobs), output = wanted_camera(request, source.pinhole);
  const auto* lens = std::get_if<Distortion>(&output.lens);
  if (lens && std::holds_alternative<Distortion>(source.lens))
    return bend(request, jobs, source.pinhole, CalibratedCamera{output.name, output.pinhole, *lens});
  return bend(request, jobs, source, output);
}

}  // namespace cps
