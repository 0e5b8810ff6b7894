#include "distortion/warp/warp.h"

#include <fmt/format.h>

#include <stdexcept>

#include "distortion/certificate/frame_certificate.h"
#include "distortion/warp/resample.h"

namespace cps {
namespace {

void check_source(const OIIO::ImageBuf& source, const Pinhole& camera, const Pinhole& output,
                  const WarpOptions& options) {
  if (const std::string fault = options.fault(); !fault.empty()) throw std::runtime_error("warp: " + fault);
  const OIIO::ImageSpec& spec = source.spec();
  if (!source.initialized() || !source.localpixels())
    throw std::runtime_error("warp: the source's pixels are not in memory");
  if (spec.width != camera.width || spec.height != camera.height)
    throw std::runtime_error(fmt::format("warp: the source is {} x {}, its camera {} x {}", spec.width,
                                         spec.height, camera.width, camera.height));
  if (spec.nchannels < 1 || spec.nchannels > 4)
    throw std::runtime_error("warp: the source needs 1 to 4 channels");
  if (output.width <= 0 || output.height <= 0 || !(output.fx > 0 && output.fy > 0))
    throw std::runtime_error("warp: the output needs a positive size and positive focal lengths");
}

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
