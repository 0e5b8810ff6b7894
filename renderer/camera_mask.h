#pragma once

#include <OpenImageIO/imagebuf.h>

#include "renderer/camera.h"

namespace cps {

/// Which pixels of the camera's picture see the scene with their whole area, through its lens: 255, or 0. One
/// channel of 8 bits. Throws std::runtime_error as make_camera_rays() does.
OIIO::ImageBuf seen_pixels(const Camera& camera);

}  // namespace cps
