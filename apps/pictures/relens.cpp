#include <fmt/format.h>

#include <stdexcept>

#include "apps/options.h"
#include "apps/pictures/picture_file.h"
#include "apps/progress.h"
#include "apps/threads.h"
#include "apps/verbs.h"
#include "dataset/exchange/calibration_file.h"
#include "dataset/exchange/camera_pictures.h"
#include "dataset/relens_draw.h"
#include "distortion/warp/view_fit.h"
#include "files/files.h"
#include "sampler/recipe/lens_keys.h"

namespace po = boost::program_options;
namespace fs = std::filesystem;

namespace cps {
namespace {

struct RelensRequest {
  std::string kitti, pictures, lens, camera, output, scheme = "shape_prior", size;
  RelensOptions options;
};

po::options_description describe(RelensRequest& r) {
  po::options_description options("Options");
  auto add = options.add_options();
  add("kitti", po::value(&r.kitti)->value_name("FOLDER"),
      "a folder of KITTI raw data, not rectified, with calib_cam_to_cam.txt");
  add("pictures", po::value(&r.pictures)->value_name("FOLDER"),
      "a folder of pictures of one camera; may be given beside --kitti");
  add("lens", po::value(&r.lens)->value_name("FILE"),
      "file with the calibration of the --pictures, in any format that cps lens check reads");
  add("lens-camera", po::value(&r.camera)->value_name("NAME"),
      "name of the camera in the --lens file, if it holds several");
  add("out,o", po::value(&r.output)->value_name("FOLDER")->required(),
      "folder for the dataset, which must not exist yet");
  add("lenses", po::value(&r.options.lenses)->default_value(r.options.lenses),
      "number of lenses for each camera, 1 to 10000");
  add("lens_draw", po::value(&r.scheme)->value_name("SCHEME")->default_value(r.scheme),
      "how lenses are drawn: sequential, shape_prior or real_lenses; cps help lens sample explains them");
  add("size", po::value(&r.size)->value_name("WxH"),
      "size of the output, WIDTHxHEIGHT in pixels [half the pictures']");
  add("narrowest", po::value(&r.options.narrowest)->default_value(r.options.narrowest),
      "smallest H-FOV of a crop before its lens, as a share of the widest that fits; above 0, at most 1");
  add("seed", po::value(&r.options.seed)->default_value(r.options.seed), "seed of the lenses");
  add_threads_option(options);
  return options;
}

std::vector<CameraPictures> sources(const RelensRequest& r) {
  if (r.kitti.empty() && r.pictures.empty()) throw po::error("name pictures: --kitti or --pictures");
  if (r.pictures.empty() != r.lens.empty()) throw po::error("--pictures and --lens go together");
  std::vector<CameraPictures> cameras;
  if (!r.kitti.empty()) {
    cameras = kitti_raw(r.kitti);
    for (CameraPictures& c : cameras) c.camera.name = "kitti" + c.camera.name;
  }
  if (!r.pictures.empty()) cameras.push_back({read_camera(r.lens, r.camera), pictures_in(r.pictures)});
  return cameras;
}

/// Straightens each picture and warps it through every lens. Only warps: the pictures have passed a sensor,
/// whose exposure and noise they keep, so photograph() has nothing to add. Returns the names of the files
/// written.
std::string make_images(const CameraPictures& source, const Pinhole& straight,
                        const std::vector<RelensGroup>& groups, const fs::path& root, Progress& progress) {
  std::string names;
  const WarpOptions straighten{.oversampling = 1, .require_coverage = false, .require_resolution = false},
      bend{.oversampling = 1};
  for (std::size_t i = 0; i < source.files.size(); ++i) {
    const Pinhole& camera = source.camera.pinhole;
    const Picture picture = read_picture(source.files[i], Encoding::automatic, Resampling::footprint,
                                         camera.width, camera.height);
    const OIIO::ImageBuf ideal =
        unwarp(picture.pixels, camera, source.camera.distortion, straight, straighten);
    for (const RelensGroup& group : groups) {
      const std::string name = fmt::format("{}/{:06}.png", group.folder, i);
      write_picture(root / name, warp(ideal, straight, group.label.distortion, group.label.camera, bend),
                    picture);
      names += name + "\n";
      progress.advance(1, name);
    }
  }
  return names;
}

}  // namespace

const Manual relens_manual{
    .name = "cps relens",
    .summary = "make a test set from real pictures, through many lenses",
    .synopsis = {"(--kitti FOLDER | --pictures FOLDER --lens CALIBRATION) -o DATASET [--lenses N] "
                 "[--lens_draw SCHEME] [--size WxH]"},
    .description = R"(
Straightens each picture by its known lens and warps it through drawn, certified
lenses and their crops, so that real pictures get many exact labels. The result
is a dataset for cps eval, whose images all belong to the test split.

A lens is drawn again if the pictures are too coarse for it, or do not show
enough.
)",
    .examples = {{"cps relens --pictures photos/ --lens camera.yml -o real --lenses 12 --size 348x128",
                  "shows photos of one camera through twelve lenses"}},
    .see_also = {"cps eval", "cps lens sample"},
};

int cps_relens(const Arguments& arguments) {
  RelensRequest request;
  po::variables_map values;
  if (!parse_options(arguments, relens_manual, describe(request), {}, values)) return 0;
  po::notify(values);
  request.options.lens.scheme = flag_value<LensScheme>("lens_draw", request.scheme);
  if (!request.size.empty()) request.options.size = picture_size("size", request.size);
  if (const std::string fault = request.options.fault(); !fault.empty()) throw po::error(fault);
  if (fs::exists(request.output)) throw std::runtime_error(request.output + ": exists; name a new folder");
  const ThreadLimit threads(values);

  const std::vector<CameraPictures> cameras = sources(request);
  std::int64_t images = 0;
  for (const CameraPictures& c : cameras)
    images += static_cast<std::int64_t>(c.files.size()) * request.options.lenses;
  Progress progress("images", 0, images);
  const fs::path root = request.output;
  std::string names;
  int first_lens = 1;
  for (const CameraPictures& source : cameras) {
    const Pinhole& camera = source.camera.pinhole;
    const ViewFit straight = fit_straight_view(source.camera, Keep::valid, camera.width, camera.height, .5);
    if (!straight.valid) throw std::runtime_error("camera " + source.camera.name + ": " + straight.why);
    const std::vector<RelensGroup> groups =
        draw_relens_groups(straight.camera, source.camera.name, first_lens, request.options);
    first_lens += static_cast<int>(groups.size());
    for (const RelensGroup& group : groups)
      write_json(root / group.folder / "calibration.json", to_json(group.label));
    names += make_images(source, straight.camera, groups, root, progress);
  }
  for (const char* part : {"train", "val"}) write_file(root / "splits" / (std::string(part) + ".txt"), {});
  write_file(root / "splits/test.txt", names);
  progress.finish();
  return 0;
}

}  // namespace cps
