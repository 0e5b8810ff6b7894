#pragma once

#include "random/counter_hash.h"
#include "trainer/images/gray_image.h"

/// Image corruptions that move nothing in the picture: every kernel is centred, and pixels beyond the border
/// repeat the outermost ones. Used for augmentation and for the robustness table.
namespace cps {

/// Gaussian blur, cut at 3 σ. Does nothing at σ = 0.
void blur(GrayImage& image, double sigma_px);

/// Replaces each pixel by the mean along a straight streak of this length centred on it, sampled bilinearly
/// every half pixel. The angle is measured from the x axis, in radians.
void motion_blur(GrayImage& image, double length_px, double angle_rad);

/// v → 255·(v/255)^gamma.
void apply_gamma(GrayImage& image, double gamma);

/// v → 127.5 + contrast·(v − 127.5) + brightness, clipped.
void apply_contrast(GrayImage& image, double contrast, double brightness);

/// Adds normal noise whose variance grows linearly with the pixel value, like photon noise: standard
/// deviation `sigma`·√(.2 + .8 v/255), in 8-bit steps.
void add_iso_noise(GrayImage& image, double sigma, Stream stream);

/// Applies the loss of baseline JPEG (ITU-T T.81; the luminance table of annex K, scaled as libjpeg does) to
/// a gray image: 8×8 cosine transform, quantisation, inverse transform. Entropy coding is lossless and left
/// out. Quality is 1…100.
void compress_as_jpeg(GrayImage& image, int quality);

/// Covers one rectangle with the image's mean gray. Its sides are uniform up to `max_share` of the image's,
/// its position is uniform.
void cut_out(GrayImage& image, double max_share, Stream stream);

}  // namespace cps
