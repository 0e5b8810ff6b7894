#pragma once

#include <Eigen/Geometry>
#include <string>

#include "distortion/brown_conrady.h"
#include "distortion/certificate/certificate.h"
#include "distortion/pinhole.h"

namespace cps {

/// Certificate of a lens that came with a camera instead of a master: a calibration from elsewhere.
struct FrameCertificate {
  Certificate certificate;  ///< on `rectangle`
  /// Of ideal points. Its image contains the whole frame; or, when there is no such rectangle, it is the
  /// largest on which the lens is certified at all.
  Eigen::AlignedBox2d rectangle;
  std::string why;  ///< of a refusal, one line; empty when valid
  bool valid() const { return certificate.valid && why.empty(); }
};

/// The smallest rectangle B similar to `shape`, about the principal point, whose distorted rim stays outside
/// the camera's frame, found by bisection, and the certificate on it. Valid: every pixel shows exactly one
/// point of B. A camera without a size or a positive focal length, or with its principal point outside the
/// frame, is refused. Without a shape, the frame's own is taken: for calibrations that come without
/// a master.
FrameCertificate certify_frame(const Distortion& lens, const Pinhole& camera,
                               const CertificateOptions& options = {});
FrameCertificate certify_frame(const Distortion& lens, const Pinhole& camera,
                               const Eigen::AlignedBox2d& shape, const CertificateOptions& options);

}  // namespace cps
