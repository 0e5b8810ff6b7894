#pragma once

#include <Eigen/Geometry>
#include <string>

#include "distortion/brown_conrady.h"
#include "distortion/certificate/certificate.h"
#include "distortion/pinhole.h"

namespace cps {

/// Certificate of a lens on the frame of its own camera, as a calibration from elsewhere gives it (there is
/// no master whose frame could be used).
struct FrameCertificate {
  Certificate certificate;  ///< on `rectangle`
  /// A rectangle of ideal points whose image contains the whole frame; if there is none, the largest
  /// rectangle on which the lens is certified at all.
  Eigen::AlignedBox2d rectangle;
  std::string why;  ///< of a refusal, one line; empty when valid
  bool valid() const { return certificate.valid && why.empty(); }
};

/// Finds, by bisection, the smallest rectangle B about the principal point, similar to `shape`, whose
/// distorted rim stays outside the camera's frame, and certifies the lens on it. Valid: every pixel shows
/// exactly one point of B. Refuses a camera without a positive size and focal length, or with its principal
/// point outside the frame. `shape` defaults to the camera's own frame.
FrameCertificate certify_frame(const Distortion& lens, const Pinhole& camera,
                               const CertificateOptions& options = {});
FrameCertificate certify_frame(const Distortion& lens, const Pinhole& camera,
                               const Eigen::AlignedBox2d& shape, const CertificateOptions& options);

}  // namespace cps
