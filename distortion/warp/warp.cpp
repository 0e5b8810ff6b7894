#include "distortion/warp/warp.h"

#include <stdexcept>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/warp/resample.h"
#include "distortion/warp/warp_checks.h"

namespace cps {
namespace {

/// The caller's box; without one, the part of the master that the output sees, or the whole master if the
/// output sees more. The lens need not be one-to-one outside that part, where the master's pad only feeds
/// footprints.
Eigen::AlignedBox2d box_to_invert_on(const Distortion& lens, const Eigen::AlignedBox2d& master,
                                     const Pinhole& output, const Eigen::AlignedBox2d& callers_box) {
  if (callers_box.isEmpty()) {
    const FrameCertificate seen = certify_frame(lens, output, master, warpable);
    if (seen.valid() && master.contains(seen.rectangle)) return seen.rectangle;
  }
  const Eigen::AlignedBox2d& box = callers_box.isEmpty() ? master : callers_box;
  if (const Certificate proof = certify(lens, box, warpable); !proof.valid)
    throw std::runtime_error("warp: " + proof.why);
  return box;
}

}  // namespace

OIIO::ImageBuf warp(const OIIO::ImageBuf& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options, WarpSummary* summary) {
  return warp_with_noise(master, nullptr, master_camera, lens, output, options, summary);
}

OIIO::ImageBuf warp_with_noise(const OIIO::ImageBuf& master, const OIIO::ImageBuf* noise,
                               const Pinhole& master_camera, const Distortion& lens, const Pinhole& output,
                               const WarpOptions& options, WarpSummary* summary) {
  check_source(master, master_camera, output, options);
  const Eigen::AlignedBox2d box = box_to_invert_on(lens, frame_on_plane(master_camera), output, options.box);
  const ResamplingGeometry geometry{lens, box, master_camera, output, options.kernel_sigma_px};
  const Footprints footprints = [&](const TileRect& rect, FootprintTile& tile) {
    distorting_footprints(geometry, rect, tile);
  };
  if (!noise) return resample(master, nullptr, output, options, footprints, summary);
  check_source(*noise, master_camera, output, options);
  const AddedNoise added{*noise, NoiseTarget(options.kernel_sigma_px)};
  return resample(master, &added, output, options, footprints, summary);
}

OIIO::ImageBuf unwarp(const OIIO::ImageBuf& source, const Pinhole& camera, const Distortion& lens,
                      const Pinhole& output, const WarpOptions& options, WarpSummary* summary) {
  check_source(source, camera, output, options);
  const FrameCertificate proof = certify_frame(lens, camera, warpable);
  if (!proof.certificate.valid) throw std::runtime_error("unwarp: " + proof.why);
  const ResamplingGeometry geometry{lens, proof.rectangle, camera, output, options.kernel_sigma_px};
  const Footprints footprints = [&](const TileRect& rect, FootprintTile& tile) {
    undistorting_footprints(geometry, rect, tile);
  };
  return resample(source, nullptr, output, options, footprints, summary);
}

}  // namespace cps
