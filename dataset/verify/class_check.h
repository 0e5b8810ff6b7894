#pragma once

#include <OpenImageIO/imagebuf.h>

#include "dataset/verify/dataset_files.h"

namespace cps {

/// Whether each pixel of a semantic label is 0 or a class that dataset.json lists for the frame's scene.
bool has_known_classes(const DatasetFiles& files, const FrameRow& frame, const OIIO::ImageBuf& semantic);

}  // namespace cps
