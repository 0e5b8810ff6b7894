#include <fmt/format.h>

#include <stdexcept>

#include "apps/options.h"
#include "apps/pictures/camera_set.h"
#include "apps/pictures/panorama_set.h"
#include "apps/threads.h"
#include "apps/verbs.h"
#include "sampler/recipe/lens_keys.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

struct RelensRequest {
  CameraSource source;
  std::string panorama, output, scheme = "shape_prior", size;
  RelensOptions options;
  PanoramaSetOptions views;  ///< of panoramas
  std::string hfov, focal, pitch, roll;
};

std::string interval_text(const Interval& interval) {
  return fmt::format("{:g}..{:g}", interval.low, interval.high);
}

/// "MIN..MAX", or one number for both. Throws boost::program_options::error naming the option.
Interval flag_interval(const std::string& flag, const std::string& text) {
  const std::size_t dots = text.find("..");
  const auto low = flag_value<double>(flag, text.substr(0, dots));
  return {low, dots == text.npos ? low : flag_value<double>(flag, text.substr(dots + 2))};
}

void describe_panoramas(RelensRequest& r, po::options_description_easy_init add) {
  add("panorama", po::value(&r.panorama)->value_name("FOLDER"),
      "instead of --kitti and --pictures: a folder of equirectangular panoramas, twice as wide as high, their "
      "horizon level");
  add("lens_model", po::value(&r.views.family)->value_name("FAMILY")->default_value(r.views.family),
      "family of the lenses that look into panoramas: brown_conrady, unified_spherical, kannala_brandt, eucm "
      "or double_sphere");
  add("views", po::value(&r.views.views)->default_value(r.views.views),
      "images of each panorama, each with a lens of its own, 1 to 10000");
  add("hfov", po::value(&r.hfov)->value_name("MIN..MAX")->default_value(interval_text(r.views.hfov_deg)),
      "range of the H-FOV of views of panoramas, degrees within 5..150: the label's; within 5..195 for "
      "families other than brown_conrady: what the image shows");
  add("focal", po::value(&r.focal)->value_name("MIN..MAX"),
      "instead of --hfov, of unified_spherical: range of the focal length for an image width of 299 pixels, "
      "pixels within 10..10000; 50..500 is DeepCalib's");
  add("pitch", po::value(&r.pitch)->value_name("MIN..MAX")->default_value(interval_text(r.views.pitch_deg)),
      "range of their pitch, upwards, degrees; write --pitch=-20..20");
  add("roll", po::value(&r.roll)->value_name("MIN..MAX")->default_value(interval_text(r.views.roll_deg)),
      "range of their roll, clockwise, degrees");
}

po::options_description describe(RelensRequest& r) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("kitti", po::value(&r.source.kitti)->value_name("FOLDER"),
      "a folder of KITTI raw data, not rectified, with calib_cam_to_cam.txt");
  add("pictures", po::value(&r.source.pictures)->value_name("FOLDER"),
      "a folder of pictures of one camera; may be given beside --kitti");
  add("lens", po::value(&r.source.lens)->value_name("FILE"),
      "file with the calibration of the --pictures, in any format that cps lens check reads");
  add("lens-camera", po::value(&r.source.lens_camera)->value_name("NAME"),
      "name of the camera in the --lens file, if it holds several");
  add("out,o", po::value(&r.output)->value_name("FOLDER")->required(),
      "folder for the dataset, which must not exist yet");
  add("lenses", po::value(&r.options.lenses)->default_value(r.options.lenses),
      "number of lenses for each camera, 1 to 10000");
  add("lens_draw", po::value(&r.scheme)->value_name("SCHEME")->default_value(r.scheme),
      "how lenses are drawn: sequential, shape_prior or real_lenses; cps help lens sample explains them");
  add("size", po::value(&r.size)->value_name("WxH"),
      "size of the output, WIDTHxHEIGHT in pixels [half the pictures', or 320x240 of panoramas]");
  add("narrowest", po::value(&r.options.narrowest)->default_value(r.options.narrowest),
      "smallest H-FOV of a crop before its lens, as a share of the widest that fits; above 0, at most 1");
  add("straight-hfov", po::value(&r.source.straight_hfov_deg),
      "H-FOV of the straightened pictures, degrees, 1 to 160 [as wide as leaves nothing black; of lenses other "
      "than brown_conrady, at most 120]");
  describe_panoramas(r, add);
  add("seed", po::value(&r.options.seed)->default_value(r.options.seed), "seed of the lenses");
  add_threads_option(options);
  return options;
}

/// Refuses options of the one source beside the other.
void check_source(const RelensRequest& request, const po::variables_map& values) {
  const bool is_panorama = !request.panorama.empty();
  const auto others = is_panorama
                          ? std::vector<const char*>{"kitti",  "pictures",  "lens",         "lens-camera",
                                                     "lenses", "narrowest", "straight-hfov"}
                          : std::vector<const char*>{"lens_model", "views", "hfov", "focal", "pitch", "roll"};
  for (const char* option : others)
    if (values.count(option) > 0 && !values[option].defaulted())
      throw po::error(fmt::format("--{}: {} --panorama", option, is_panorama ? "does not go with" : "needs"));
  if (values.count("focal") > 0 && !values["hfov"].defaulted())
    throw po::error("--focal: takes the place of --hfov; leave one of them out");
  if (request.views.family != "brown_conrady" && !values["lens_draw"].defaulted())
    throw po::error("--lens_draw: draws brown_conrady lenses; leave it out with another --lens_model");
}

void finish(RelensRequest& request, const po::variables_map& values) {
  check_source(request, values);
  request.options.lens.scheme = flag_value<LensScheme>("lens_draw", request.scheme);
  if (!request.size.empty()) request.options.size = request.views.size = picture_size("size", request.size);
  request.views.hfov_deg = flag_interval("hfov", request.hfov);
  if (!request.focal.empty()) request.views.focal_px = flag_interval("focal", request.focal);
  request.views.pitch_deg = flag_interval("pitch", request.pitch);
  request.views.roll_deg = flag_interval("roll", request.roll);
  request.views.lens = request.options.lens;
  request.views.seed = request.options.seed;
  if (!request.panorama.empty()) return refuse_flags_with(request.views.fault());
  if (request.source.kitti.empty() && request.source.pictures.empty())
    throw po::error("name pictures: --kitti or --pictures");
  if (request.source.pictures.empty() != request.source.lens.empty())
    throw po::error("--pictures and --lens go together");
  if (const std::string fault = request.options.fault(); !fault.empty()) throw po::error(fault);
  if (values.count("straight-hfov") > 0 &&
      !(request.source.straight_hfov_deg >= 1 && request.source.straight_hfov_deg <= 160))
    throw po::error("--straight-hfov: must lie between 1 and 160 degrees");
}

}  // namespace

const Manual relens_manual{
    .name = "cps relens",
    .summary = "make a test set from real pictures, through many lenses",
    .synopsis = {"(--kitti FOLDER | --pictures FOLDER --lens CALIBRATION) -o DATASET [--lenses N] "
                 "[--lens_draw SCHEME] [--size WxH]",
                 "--panorama FOLDER -o DATASET [--lens_model FAMILY] [--views N] "
                 "[--hfov MIN..MAX | --focal MIN..MAX] "
                 "[--pitch MIN..MAX] [--roll MIN..MAX] [--size WxH]"},
    .description = R"(
Straightens each picture by its known lens and warps it through drawn, certified
lenses and their crops, so that real pictures get many exact labels. The result
is a dataset for cps eval, whose images all belong to the test split.

A lens is drawn again if the pictures are too coarse for it, or do not show
enough. The pictures may come from a lens of any family that cps lens check
reads; of a fisheye, as much is used as a straight picture can show.

With --panorama, cameras with drawn lenses look into equirectangular panoramas
in drawn directions. The labels know the lens and the direction of gravity. All
views of a panorama belong to one of train, val and test, by a hash of its file's
name. A dataset of lenses other than brown_conrady is no CPS dataset and says so
in its dataset.json.
)",
    .examples = {{"cps relens --pictures photos/ --lens camera.yml -o real --lenses 12 --size 348x128",
                  "shows photos of one camera through twelve lenses"},
                 {"cps relens --panorama panoramas/ -o real --views 50 --hfov 50..100",
                  "looks into each panorama through fifty lenses"},
                 {"cps relens --panorama panoramas/ -o fisheyes --lens_model kannala_brandt --hfov 120..190",
                  "does so through fisheyes"},
                 {"cps relens --panorama panoramas/ -o crops --lens_model unified_spherical --focal 50..500 "
                  "--size 299x299",
                  "draws what DeepCalib trains on"}},
    .see_also = {"cps eval", "cps lens sample"},
};

int cps_relens(const Arguments& arguments) {
  RelensRequest request;
  po::variables_map values;
  if (!parse_options(arguments, relens_manual, describe(request), {}, values)) return 0;
  po::notify(values);
  finish(request, values);
  if (fs::exists(request.output)) throw std::runtime_error(request.output + ": exists; name a new folder");
  const ThreadLimit threads(values);
  if (request.panorama.empty())
    make_camera_set(request.source, request.output, request.options);
  else
    make_panorama_set(request.panorama, request.output, request.views);
  return 0;
}

}  // namespace cps
