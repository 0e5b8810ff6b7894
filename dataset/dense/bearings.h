#pragma once

#include <OpenImageIO/imagebuf.h>

#include "distortion/calibrated_camera.h"
#include "distortion/models/model_camera.h"
#include "sampler/recipe/dense_label.h"

namespace cps {

/// Pixels of `rays`, `up` or `latitude` of a camera whose lens is one-to-one on its frame, as dense_file.h
/// lists them: float, at the camera's size, each computed in double at the pixel's centre. `gravity`: unit
/// vector downwards in the camera frame. `up` is the direction in which the picture of a point moves when the
/// point rises: 0 where the ray is vertical. Throws std::runtime_error with one line when the lens is not
/// one-to-one on the frame, or for another label.
OIIO::ImageBuf bearing_label(const CalibratedCamera& camera, const Eigen::Vector3d& gravity,
                             DenseLabel label);

/// The same of a camera of any lens family. Where a lens of another family than Brown–Conrady shows nothing,
/// all channels are 0. Throws std::runtime_error with one line when such a lens is proved nowhere.
OIIO::ImageBuf bearing_label(const ModelCamera& camera, const Eigen::Vector3d& gravity, DenseLabel label);

}  // namespace cps
