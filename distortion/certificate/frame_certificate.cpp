#include "distortion/certificate/frame_certificate.h"

#include "distortion/certificate/grow_rectangle.h"

namespace cps {

FrameCertificate certify_frame(const Distortion& lens, const Pinhole& camera,
                               const CertificateOptions& options) {
  return certify_frame(lens, camera, frame_on_plane(camera), options);
}

FrameCertificate certify_frame(const Distortion& lens, const Pinhole& camera,
                               const Eigen::AlignedBox2d& shape, const CertificateOptions& options) {
  return certify_grown_rectangle(lens, camera, shape, options);
}

}  // namespace cps
