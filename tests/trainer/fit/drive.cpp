#include "tests/trainer/fit/drive.h"

#include <cmath>

#include "numbers/angles.h"
#include "tests/trainer/fit/evidence.h"

namespace cps {

FitVector reading_deviation() {
  FitVector deviation;
  deviation << radians(4), .04, .02, .005, .003, .003, .01, .015, angle_deviation[0], angle_deviation[1],
      angle_deviation[2];
  return deviation;
}

FitVector drawn_camera(Stream stream) {
  FitVector camera = wide_prior(drive_picture).mean;
  camera[0] = radians(random_uniform(stream, 0, 60, 90));
  camera[1] = random_uniform(stream, 1, -.15, 0);
  camera[2] = -.25 * camera[1];
  camera[3] = 0;
  camera[4] = random_uniform(stream, 2, -.003, .003);
  camera[5] = random_uniform(stream, 3, -.003, .003);
  camera[6] += random_uniform(stream, 4, -.01, .01);
  camera[7] += random_uniform(stream, 5, -.02, .02);
  return camera;
}

std::vector<FrameEvidence> drive(const FitVector& camera, int frames, Stream stream,
                                 const FilmedDriveOptions& options) {
  const FitVector deviation = reading_deviation();
  const Stream common = make_stream(stream.key, "common");
  std::vector<FrameEvidence> evidence;
  for (int i = 0; i < frames; ++i) {
    const Stream of_frame = substream(stream, i), own = make_stream(of_frame.key, "own");
    FitVector truth = camera;
    LensPrior read{camera, FitMatrix(deviation.cwiseAbs2().cwiseInverse().asDiagonal())};
    for (int k = 0; k < output_count; ++k)
      read.mean[k] += deviation[k] * (std::sqrt(options.common_share) * random_normal(common, k) +
                                      std::sqrt(1 - options.common_share) * random_normal(own, k));
    for (int k = output_count; k < fit_parameter_count; ++k) truth[k] += deviation[k] * random_normal(own, k);
    evidence.push_back(synthetic_evidence(read, truth, drive_picture, options.edge_weight, of_frame));
  }
  return evidence;
}

std::vector<FrameEvidence> exact_drive(const FitVector& camera, int frames, double edge_weight) {
  FrameEvidence frame =
      synthetic_evidence({camera, FitMatrix(reading_deviation().cwiseAbs2().cwiseInverse().asDiagonal())},
                         camera, drive_picture, edge_weight, make_stream(1, "exact"));
  const TiltModel model = tilt_model(frame, camera);
  for (std::size_t i = 0; i < model.tilt.size(); ++i)
    frame.edges.weighted_tilt[i] = static_cast<float>(frame.edges.weight[i] * model.tilt[i]);
  return std::vector<FrameEvidence>(frames, frame);
}

}  // namespace cps
