#include <Eigen/LU>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "distortion/certificate/frame_certificate.h"
#include "numbers/angles.h"
#include "tests/trainer/fit/drive.h"
#include "trainer/fit/convergence.h"

using namespace cps;

namespace {

OneCamera camera_of_drive(const std::vector<FrameEvidence>& frames, const OneCameraOptions& options = {}) {
  return fit_one_camera(fit_each(frames), options);
}

/// How far b is from a in the standard deviations of a, for each output.
Outputs moved_by(const OneCamera& a, const OneCamera& b) {
  Outputs off = b.posterior.mean;
  const Outputs deviation = a.posterior.deviation();
  for (int k = 0; k < output_count; ++k) off[k] = std::abs(off[k] - a.posterior.mean[k]) / deviation[k];
  return off;
}

double largest_move(const Outputs& off) {
  return *std::ranges::max_element(off);
}

double rms_move(const Outputs& off) {
  double sum = 0;
  for (double o : off) sum += o * o / output_count;
  return std::sqrt(sum);
}

/// Eight frames of one camera, then two of another: a fifth.
std::vector<FrameEvidence> drive_with_strangers() {
  const FitVector camera = drawn_camera(make_stream(3, "camera"));
  FitVector stranger = camera;
  stranger[0] += radians(30);
  stranger[1] += .2;
  std::vector<FrameEvidence> frames = drive(camera, 8, make_stream(3, "drive"));
  for (const FrameEvidence& frame : drive(stranger, 2, make_stream(3, "strangers"))) frames.push_back(frame);
  return frames;
}

/// Tilts of a fifth of the blocks become ±.2.
void make_wild(FrameEvidence& frame, Stream stream) {
  for (std::size_t i = 0; i < frame.edges.weight.size(); ++i) {
    const double drawn = random_uniform(stream, i);
    if (drawn < .2) frame.edges.weighted_tilt[i] = frame.edges.weight[i] * (drawn < .1 ? -.2f : .2f);
  }
}

}  // namespace

TEST_CASE("errors of a camera from many frames are those that its covariance states") {
  // The squared distance of an estimate from the truth has a χ² distribution of 8 degrees of freedom. The sum
  // over the cameras is within the 99.9 % interval of its own (3.29 standard deviations), and a little more
  // because the model is not linear and weights take a few percent.
  constexpr int cameras = 30;
  double sum = 0;
  for (int i = 0; i < cameras; ++i) {
    const Stream stream = substream(make_stream(7, "cameras"), i);
    const FitVector camera = drawn_camera(stream);
    const OneCamera fitted = camera_of_drive(drive(camera, 4, stream));
    Eigen::Matrix<double, output_count, 1> error;
    for (int k = 0; k < output_count; ++k) error[k] = fitted.posterior.mean[k] - camera[k];
    sum += error.dot(fitted.posterior.covariance.inverse() * error);
  }
  const double expected = double(output_count) * cameras;
  CHECK(sum == Approx(expected).margin(3.29 * std::sqrt(2 * expected) + .05 * expected));
}

TEST_CASE(
    "deviations shrink with the root of the frames by edges; by what is read only to the common share") {
  const FitVector camera = drawn_camera(make_stream(5, "camera"));
  const auto variances = [&](int frames, double edge_weight, double common_share) {
    const OneCamera fitted =
        camera_of_drive(exact_drive(camera, frames, edge_weight), {.common_share = common_share});
    CHECK(fitted.trusted_frames() == frames);
    return Eigen::Matrix<double, output_count, 1>(fitted.posterior.covariance.diagonal());
  };
  // With nothing in common, edges and numbers are independent measurements.
  const auto one = variances(1, 2500, 0), nine = variances(9, 2500, 0);
  for (int k = 0; k < output_count; ++k) CHECK(nine[k] == Approx(one[k] / 9).epsilon(1e-3));
  // Without edges, the variance of the mean of numbers that have a share of theirs in common.
  for (int frames : {4, 50})
    for (double share : {0., .25, 1.}) {
      const auto of_mean = variances(frames, 0, share);
      for (int k = 0; k < output_count; ++k) {
        INFO(frames << " frames, share " << share << ", output " << k);
        const double read = reading_deviation()[k] * reading_deviation()[k];
        CHECK(of_mean[k] == Approx(read * (share + (1 - share) / frames)).epsilon(1e-6));
      }
    }
  // Edges alone shrink when all of what is read is common: information = frames · edges + numbers.
  const auto information = [&](int frames) -> OutputCovariance {
    return camera_of_drive(exact_drive(camera, frames, 2500), {.common_share = 1})
        .posterior.covariance.inverse();
  };
  OutputCovariance edges = information(1);
  edges.diagonal() -= reading_deviation().head<output_count>().cwiseAbs2().cwiseInverse();
  const OutputCovariance added = information(9) - information(1);
  CHECK((added - 8 * edges).norm() < 1e-3 * added.norm());
}

TEST_CASE("frames of another camera move the estimate by less than its deviation") {
  const std::vector<FrameEvidence> all = drive_with_strangers(), own(all.begin(), all.begin() + 8);
  const OneCamera alone = camera_of_drive(own), with = camera_of_drive(all);
  CHECK(largest_move(moved_by(alone, with)) < 1);
  CHECK(with.trusted_frames() >= 7);
  for (std::size_t i : {8, 9}) CHECK(with.frames[i].weight < .5);
  // So they would without weights.
  CHECK(largest_move(moved_by(camera_of_drive(own, {.rounds = 0}), camera_of_drive(all, {.rounds = 0}))) >
        1.5);
}

TEST_CASE("wild edges and frames of another camera together move the estimate by less than its deviation") {
  std::vector<FrameEvidence> all = drive_with_strangers();
  const OneCamera alone = camera_of_drive({all.begin(), all.begin() + 8});
  for (std::size_t i = 0; i < all.size(); ++i) make_wild(all[i], substream(make_stream(4, "wild"), i));
  const OneCamera robust = camera_of_drive(all), plain = camera_of_drive(all, {.rounds = 0});
  CHECK(rms_move(moved_by(alone, robust)) < 1);
  CHECK(rms_move(moved_by(alone, plain)) > 1.5 * rms_move(moved_by(alone, robust)));
  CHECK(robust.trusted_frames() >= 7);
}

TEST_CASE("the order of frames changes nothing") {
  const std::vector<CameraFrame> frames = fit_each(drive_with_strangers());
  const std::vector<CameraFrame> reversed(frames.rbegin(), frames.rend());
  const OneCamera one = fit_one_camera(frames), other = fit_one_camera(reversed);
  CHECK(largest_move(moved_by(one, other)) < 1e-6);
  CHECK((one.posterior.covariance - other.posterior.covariance).norm() <
        1e-6 * one.posterior.covariance.norm());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const FrameInCamera &a = one.frames[i], &b = other.frames[frames.size() - 1 - i];
    CHECK(a.weight == Approx(b.weight).epsilon(1e-6));
    CHECK(a.pitch_rad == Approx(b.pitch_rad).margin(1e-8));
    CHECK(a.yaw_rad == Approx(b.yaw_rad).margin(1e-8));
  }
}

TEST_CASE("one frame gives its own fit") {
  const std::vector<FrameEvidence> one =
      drive(drawn_camera(make_stream(8, "camera")), 1, make_stream(8, "drive"));
  const LensFit fit = fit_lens(one.front());
  const OneCamera camera = camera_of_drive(one);
  const FitMatrix covariance = fit.information.inverse();
  const Outputs deviation = camera.posterior.deviation();
  for (int k = 0; k < output_count; ++k) {
    CHECK(camera.posterior.mean[k] == Approx(fit.parameters[k]).margin(.01 * deviation[k]));
    CHECK(deviation[k] == Approx(std::sqrt(covariance(k, k))).epsilon(1e-3));
  }
  CHECK(camera.frames.front().weight == 1);
  CHECK(camera.frames.front().roll_rad == Approx(fit.parameters[roll_parameter]).margin(1e-3));
}

TEST_CASE("the certified lens is that of the estimate; a deviation scale multiplies its deviations") {
  const std::vector<FrameEvidence> two =
      drive(drawn_camera(make_stream(9, "camera")), 2, make_stream(9, "drive"));
  const OneCamera plain = camera_of_drive(two),
                  scaled = camera_of_drive(two, {.deviation_scale = {2, 3, 1, 1, 1, 1, 1, .5}});
  CHECK(scaled.posterior.mean == plain.posterior.mean);
  CHECK(scaled.posterior.covariance(0, 1) == Approx(6 * plain.posterior.covariance(0, 1)));
  CHECK(scaled.posterior.deviation()[7] == Approx(.5 * plain.posterior.deviation()[7]));
  const CalibratedCamera& certified = plain.certified.camera;
  CHECK(certify_frame(certified.distortion, certified.pinhole).valid());
  CHECK(plain.certified.kept == 1);
  CHECK(to_outputs(certified, TargetSpace::seen)[1] == Approx(plain.posterior.mean[1]));
}

TEST_CASE("the numbers settle with more frames") {
  const std::vector<CameraFrame> frames =
      fit_each(drive(drawn_camera(make_stream(2, "camera")), 11, make_stream(2, "drive")));
  const OneCamera all = fit_one_camera(frames);
  const std::vector<ConvergencePoint> points = convergence(frames, all);
  std::vector<int> counts;
  for (const ConvergencePoint& point : points) counts.push_back(point.frames);
  CHECK(counts == std::vector{1, 2, 4, 8, 11});
  CHECK(points.back().posterior.mean == all.posterior.mean);
  for (int k = 0; k < output_count; ++k)
    CHECK(points.back().posterior.deviation()[k] < points.front().posterior.deviation()[k]);
  CHECK(convergence(frames, all)[2].posterior.mean == points[2].posterior.mean);
}

TEST_CASE("options of a camera from many frames that mean nothing are refused by name") {
  CHECK(OneCameraOptions{}.fault().empty());
  CHECK(OneCameraOptions{.common_share = 1.5}.fault() == "common-share: must lie in [0, 1]");
  CHECK(OneCameraOptions{.common_share = NAN}.fault() == "common-share: must lie in [0, 1]");
  CHECK(OneCameraOptions{.degrees_of_freedom = 0}.fault() == "degrees-of-freedom: must be above 0");
  CHECK(OneCameraOptions{.rounds = -1}.fault() == "rounds: must lie in [0, 100]");
  CHECK(OneCameraOptions{.deviation_scale = {}}.fault() == "deviation-scale: must be above 0");
}
