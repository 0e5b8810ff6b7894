#include "distortion/warp/warp_checks.h"

#include <fmt/format.h>

#include <stdexcept>

#include "distortion/warp/footprints.h"

namespace cps {

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

void check_summary(const WarpSummary& summary, const WarpOptions& options) {
  if (options.require_coverage && summary.uncovered_pixels > 0)
    throw std::runtime_error("warp: " + std::to_string(summary.uncovered_pixels) +
                             " pixels see beyond the source: pad the master, or crop further");
  if (options.require_resolution && summary.smallest_kernel_sigma_px < narrowest_sigma_px)
    throw std::runtime_error("warp: the image is magnified beyond what its source carries (kernel of " +
                             std::to_string(summary.smallest_kernel_sigma_px) +
                             " source pixels): oversample more");
}

}  // namespace cps
