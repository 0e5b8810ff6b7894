#pragma once

#include <OpenImageIO/imagebuf.h>

#include <span>

#include "sensor/sensor.h"

/// What the sensor does after the lens: exposure, noise, response curve, 8 bit. It comes after the warp, so
/// that noise and quantisation do not depend on the lens.
namespace cps {

/// The factor that brings a view's mean luminance to 18 % of white, metered on the middle half (in width and
/// height) of the linear master: it is the same for every lens. A pixel counts at most eight times the
/// median, so that the sun does not set the exposure. A black image gives 1. `linear_master` has three float
/// channels.
double meter_exposure(const OIIO::ImageBuf& linear_master);

/// A linear image of three float channels, and which of its pixels count.
struct MeteredImage {
  const OIIO::ImageBuf* linear;
  const OIIO::ImageBuf* valid = nullptr;  ///< a mask: those that are not 0; null: all
};

/// The same factor for images that share an exposure: metered on the middle halves of all together.
double meter_exposure(std::span<const MeteredImage> images);

/// Rec. 709 luminance of three linear float channels: what a sensor without colours sees.
OIIO::ImageBuf luminance(const OIIO::ImageBuf& linear);

/// The factor from radiance to share of white, `exposure`·2^bias.
double exposure_factor(double exposure, const SensorSettings& settings);

/// Linear radiance → share of white, without noise or clipping. `linear` has float channels.
OIIO::ImageBuf expose(const OIIO::ImageBuf& linear, double exposure, const SensorSettings& settings);

/// Linear radiance → 8-bit sRGB (IEC 61966-2-1): scaled by `exposure`·2^bias, shot and read noise as a normal
/// of variance (signal + read²) electrons per channel and image pixel, the tone curve of the settings'
/// contrast, clipped at white, encoded, rounded. Noise is a pure function of (noise, pixel, channel).
/// `linear` has float channels.
OIIO::ImageBuf develop(const OIIO::ImageBuf& linear, double exposure, const SensorSettings& settings,
                       Stream noise);

}  // namespace cps
