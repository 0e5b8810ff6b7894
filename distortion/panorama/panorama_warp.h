#pragma once

#include <OpenImageIO/imagebuf.h>

#include <Eigen/Core>

#include "distortion/models/model_camera.h"
#include "distortion/warp/warp.h"

namespace cps {

/// The rotation panorama_from_camera of a camera turned in a panorama: first by yaw to the right about the
/// vertical, then up by pitch, then clockwise (as the picture's content turns counter-clockwise) by roll
/// about its own axis. Radians, between −100 and 100.
Eigen::Matrix3d panorama_from_camera(double yaw_rad, double pitch_rad, double roll_rad);

/// The picture that `camera` takes of an equirectangular panorama, linear, 1 to 4 channels, resampled once:
/// each pixel is a kernel-weighted mean over its true footprint on the sphere, across the seam and the poles
/// alike (spherical_footprint.h). A pixel whose footprint reaches more than widest_reach_rad is 0 and counts
/// as uncovered. The result has the panorama's pixel type, and the same bytes for any number of threads.
/// Throws std::runtime_error in one line: a panorama that is not twice as wide as high, a lens that is not
/// proved one-to-one on its frame, magnification above what the panorama carries
/// (options.require_resolution), uncovered pixels (options.require_coverage), and unusable options, as warp()
/// does.
OIIO::ImageBuf photograph_panorama(const OIIO::ImageBuf& panorama,
                                   const Eigen::Matrix3d& panorama_from_camera, const ModelCamera& camera,
                                   const WarpOptions& options = {}, WarpSummary* summary = nullptr);

}  // namespace cps
