#include "tests/recalibration/trial.h"

#include "distortion/warp/master_camera.h"
#include "numbers/angles.h"
#include "renderer/render.h"
#include "sensor/photograph.h"
#include "tests/recalibration/corner_search.h"

namespace cps {
namespace {
constexpr double border_px = 13, min_square_px = 22;
}

CameraParameters label(const Trial& trial) {
  return camera_parameters(trial.lens.crop.camera, trial.lens.distortion);
}

CameraParameters rough_start(const CameraParameters& label) {
  CameraParameters start = label;
  start.head<2>() *= 1.01;
  start[2] += 3;
  start[3] -= 3;
  start.tail<5>() *= 0.95;
  return start;
}

Pinhole base_of(const LensSet& set) {
  return pinhole_from_hfov(set.width, set.height, radians(set.base_hfov_deg));
}

/// The board seen from one pose, before any lens.
Master render_master(const RenderScene& board, const Eigen::Isometry3d& world_from_camera,
                     const Pinhole& camera, std::uint64_t seed) {
  const auto half = [&](std::uint64_t half_seed) {
    return render(board, {.world_from_camera = world_from_camera, .pinhole = camera},
                  {.samples = 4, .max_shaded_vertices = 1, .seed = half_seed});
  };
  return master_from_halves(half(seed), half(make_stream(seed, "second half").key), camera);
}

std::vector<Trial> draw_trials(const LensSet& set, Stream stream) {
  std::vector<Trial> trials;
  for (int i = 0; i < set.lenses; ++i)
    trials.push_back({.lens = draw_lens(base_of(set), CropOrder::base_first, {}, substream(stream, i)),
                      .seen = frame_on_plane(base_of(set))});
  return trials;
}

std::vector<BoardCorner> corners_of(const Trial& trial, const Eigen::Isometry3d& world_from_camera) {
  return visible_corners(world_from_camera, trial.lens.crop.camera, trial.lens.distortion, trial.seen,
                         border_px, min_square_px);
}

std::vector<Trial> photograph_board(const LensSet& set, const RenderScene& board, Stream stream) {
  const Pinhole base = base_of(set);
  const Pinhole master_pinhole = master_camera(base, WarpOptions{}, LensBounds{}.min_eigenvalue);
  // The least noisy of the sensors that a recipe draws.
  const SensorOptions sensor{.full_well_min_e = 12000, .read_noise_max_e = 2};
  std::vector<Trial> trials = draw_trials(set, make_stream(stream.key, "lens"));
  for (int v = 0; v < views_per_lens; ++v) {
    const Eigen::Isometry3d pose = chessboard_pose(base, make_stream(stream.key, "pose"), v);
    const Master master = render_master(board, pose, master_pinhole, random_bits(stream, v));
    for (std::size_t i = 0; i < trials.size(); ++i) {
      const Stream photo = substream(make_stream(stream.key, "photograph"), v * trials.size() + i);
      const std::vector<BoardCorner> corners = corners_of(trials[i], pose);
      trials[i].predicted_corners += static_cast<int>(corners.size());
      const cv::Mat gray = linear_gray(
          photograph(master, cropped(trials[i].lens), sensor_of(sensor, photo), PixelFormat::rgb));
      trials[i].views.push_back(find_corners(gray, corners, make_stream(photo.key, "start")));
      trials[i].photographs.push_back(gray);
    }
  }
  return trials;
}

Calibration calibrate(const Trial& trial) {
  const int width = trial.lens.crop.camera.width, height = trial.lens.crop.camera.height;
  const Calibration first = calibrate(trial.views, width, height, rough_start(label(trial)));
  std::vector<BoardView> fitted;
  for (std::size_t v = 0; v < trial.views.size(); ++v)
    fitted.push_back(fit_corners(trial.photographs[v], trial.views[v], first, v));
  return calibrate(fitted, width, height, first.parameters);
}

}  // namespace cps
