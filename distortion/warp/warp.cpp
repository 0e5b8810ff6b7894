#include "distortion/warp/warp.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/warp/resample.h"

namespace cps {
namespace {

void check_source(const OIIO::ImageBuf& source, const Pinhole& camera, const Pinhole& output,
                  const WarpOptions& options) {
  std::string why;
  if (!options.is_valid(&why)) throw std::runtime_error("warp: " + why);
  const OIIO::ImageSpec& spec = source.spec();
  if (!source.initialized() || !source.localpixels())
    throw std::runtime_error("warp: the source's pixels are not in memory");
  if (spec.width != camera.width || spec.height != camera.height)
    throw std::runtime_error("warp: the source is " + std::to_string(spec.width) + " x " +
                             std::to_string(spec.height) + ", its camera " + std::to_string(camera.width) +
                             " x " + std::to_string(camera.height));
  if (spec.nchannels < 1 || spec.nchannels > 4)
    throw std::runtime_error("warp: the source needs 1 to 4 channels");
  if (output.width <= 0 || output.height <= 0 || !(output.fx > 0 && output.fy > 0))
    throw std::runtime_error("warp: the output needs a positive size and positive focal lengths");
}

/// The caller's box; else the part of the master that the output sees, or all of it if it sees more. The lens
/// need not be one-to-one beyond, where the pad only feeds footprints.
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

bool WarpOptions::is_valid(std::string* why) const {
  if (!(oversampling >= 1 && oversampling <= 8)) {
    *why = "oversampling: must lie between 1 and 8";
    return false;
  }
  if (!(kernel_sigma_px >= 0.3 && kernel_sigma_px <= 4)) {
    *why = "kernel_sigma_px: must lie between 0.3 and 4";
    return false;
  }
  return true;
}

int master_pad(const WarpOptions& options, double min_eigenvalue) {
  return int(std::ceil(kernel_support * options.kernel_sigma_px * options.oversampling / min_eigenvalue));
}

Pinhole master_camera(const Pinhole& base, const WarpOptions& options, double min_eigenvalue) {
  return oversampled(base, options.oversampling, master_pad(options, min_eigenvalue));
}

double largest_magnification(const WarpOptions& options) {
  // sigma² (oversampling / magnification)² − 1/12 ≥ narrowest².
  return options.oversampling * options.kernel_sigma_px /
         std::sqrt(1.0 / 12 + narrowest_sigma_px * narrowest_sigma_px);
}

std::string WarpSummary::brief() const {
  char line[160];
  std::snprintf(line, sizeof line,
                "warp %.3f s, worst inverse residual %.2g px, %lld uncovered, kernel >= %.2f source px",
                seconds, worst_residual_px, static_cast<long long>(uncovered_pixels),
                smallest_kernel_sigma_px);
  return line;
}

OIIO::ImageBuf warp(const OIIO::ImageBuf& master, const Pinhole& master_camera, const Distortion& lens,
                    const Pinhole& output, const WarpOptions& options, WarpSummary* summary) {
  return warp_through({}, master, master_camera, lens, output, options, summary);
}

OIIO::ImageBuf warp_through(const FootprintChange& change, const OIIO::ImageBuf& master,
                            const Pinhole& master_camera, const Distortion& lens, const Pinhole& output,
                            const WarpOptions& options, WarpSummary* summary) {
  check_source(master, master_camera, output, options);
  const Eigen::AlignedBox2d box = box_to_invert_on(lens, frame_on_plane(master_camera), output, options.box);
  const Footprints footprints = [&](int x0, int y0, int width, int height, FootprintTile& tile) {
    distorting_footprints(lens, box, master_camera, output, options.kernel_sigma_px, x0, y0, width, height,
                          tile);
    if (change) change(tile);
  };
  return resample(master, output, options, footprints, summary);
}

OIIO::ImageBuf unwarp(const OIIO::ImageBuf& source, const Pinhole& camera, const Distortion& lens,
                      const Pinhole& output, const WarpOptions& options, WarpSummary* summary) {
  check_source(source, camera, output, options);
  const FrameCertificate proof = certify_frame(lens, camera, warpable);
  if (!proof.certificate.valid) throw std::runtime_error("unwarp: " + proof.why);
  const Footprints footprints = [&](int x0, int y0, int width, int height, FootprintTile& tile) {
    undistorting_footprints(lens, proof.rectangle, camera, output, options.kernel_sigma_px, x0, y0, width,
                            height, tile);
  };
  return resample(source, output, options, footprints, summary);
}

}  // namespace cps
