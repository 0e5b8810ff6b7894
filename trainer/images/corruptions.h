#pragma once

#include "random/counter_hash.h"
#include "trainer/images/gray_image.h"

/// What can befall a picture without moving anything in it: every kernel is centred, and the border repeats
/// the outermost pixels. Used as augmentations and for the table of robustness.
namespace cps {

/// Gaussian, cut at 3 σ. Nothing happens at σ = 0.
void blur(GrayImage& image, double sigma_px);

/// The mean along a straight streak of this length, centred on the pixel, sampled every half pixel
/// bilinearly. Angle from the x axis, radians.
void motion_blur(GrayImage& image, double length_px, double angle_rad);

/// 255·(v/255)^gamma.
void apply_gamma(GrayImage& image, double gamma);

/// 127.5 + contrast·(v − 127.5) + brightness, clipped.
void apply_contrast(GrayImage& image, double contrast, double brightness);

/// Normal noise whose variance grows linearly with the pixel, as photons' does: standard deviation
/// `sigma`·√(.2 + .8 v/255), in 8-bit steps.
void add_iso_noise(GrayImage& image, double sigma, Stream stream);

/// What baseline JPEG (ITU-T T.81, its annex K's luminance table scaled as libjpeg does) makes of a gray
/// image: 8×8 cosine transform, quantisation and back. Entropy coding loses nothing and is left out.
void compress_as_jpeg(GrayImage& image, int quality);

/// One rectangle of the image's mean gray; its sides are uniform up to `max_share` of the image's, its place
/// uniform.
void cut_out(GrayImage& image, double max_share, Stream stream);

}  // namespace cps
