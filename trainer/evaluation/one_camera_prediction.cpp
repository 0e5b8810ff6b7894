#include "trainer/evaluation/one_camera_prediction.h"

#include <fmt/format.h>

#include <set>
#include <stdexcept>
#include <utility>

#include "trainer/calibration/reprojection.h"
#include "trainer/evaluation/read_pictures.h"
#include "trainer/evaluation/truth_beside.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

std::vector<FrameEvidence> evidence_of(const Predictor& predictor, std::span<const fs::path> files,
                                       const ImageSize& size) {
  std::vector<SizedPicture> pictures;
  for (const fs::path& file : files) pictures.push_back({file, size});
  const ReadPictures read = read_pictures(pictures, predictor.card().options, false);
  std::vector<BatchImage> batch;
  for (const NetworkImage& image : read.images) batch.push_back(batch_image(image, size));
  return predictor.evidence(batch);
}

}  // namespace

ImageSize common_size(std::span<const fs::path> files) {
  const ImageSize size = gray_image_size(files.front());
  for (const fs::path& file : files) {
    const ImageSize other = gray_image_size(file);
    if (other != size)
      throw std::runtime_error(fmt::format(
          "{}: is {}x{}, but {} is {}x{}: pictures of one camera must have one size", file.string(),
          other.width, other.height, files.front().string(), size.width, size.height));
  }
  return size;
}

std::optional<CalibratedCamera> common_truth(std::span<const fs::path> files, const ImageSize& size) {
  std::optional<CalibratedCamera> common;
  fs::path named_by;
  std::set<fs::path> seen;
  for (const fs::path& file : files) {
    if (!seen.insert(file.parent_path()).second) continue;
    const std::optional<CalibratedCamera> truth = truth_beside(file, size);
    if (!truth) continue;
    if (common && *truth != *common)
      throw std::runtime_error(
          fmt::format("{}: its calibration.json is of another camera than that beside {}: name pictures of "
                      "one camera",
                      file.string(), named_by.string()));
    common = truth;
    named_by = file;
  }
  return common;
}

OneCameraPrediction predict_one_camera(const Predictor& predictor, std::span<const fs::path> files,
                                       OneCameraOptions options) {
  options.deviation_scale = predictor.card().deviation_scale;
  const ImageSize size = common_size(files);
  const auto raw = [&](const LensPosterior& posterior) {
    return convert(posterior, TargetSpace::seen, TargetSpace::raw, size.width, size.height);
  };
  OneCameraPrediction result;
  result.files.assign(files.begin(), files.end());
  result.size = size;
  result.truth = common_truth(files, size);
  const std::vector<CameraFrame> frames = fit_each(evidence_of(predictor, files, size));
  result.camera = fit_one_camera(frames, options);
  const LensPosterior posterior = raw(result.camera.posterior);
  result.fitted = to_camera(posterior.mean, TargetSpace::raw, size.width, size.height).value();
  result.deviation = posterior.deviation();
  for (const ConvergencePoint& point : convergence(frames, result.camera, options))
    result.convergence.push_back({point.frames, raw(point.posterior)});
  if (!result.truth) return result;
  if (const auto rays = ray_grid(*result.truth))
    result.reprojection_px = reprojection_error_px(*rays, result.fitted);
  return result;
}

}  // namespace cps
