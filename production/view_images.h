#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "dataset/job/records.h"
#include "production/frame_exposure.h"
#include "production/view_render.h"
#include "sampler/plan/plan.h"
#include "sensor/photograph.h"

namespace cps {

/// One image to be made of a view's render.
struct PlannedImage {
  std::string file;  ///< relative to the dataset
  CroppedLens lens;
  Stream sensor;  ///< of its settings and noise
};

/// All that is made of one view's render.
struct ViewImages {
  std::int64_t view = 0;  ///< index into Plan::views
  Pinhole master;         ///< the render's camera
  std::vector<PlannedImage> images;
  std::string master_file = {};  ///< relative to the dataset; empty: the render is not kept
  SensorOptions sensor;
  ImageFormat format = ImageFormat::png;
  int jpeg_quality = 95;
};

/// The images that the plan has for a view. An image's sensor is drawn from the view and the lens's number
/// alone, so that it does not depend on the lens itself.
ViewImages images_of(const Plan& plan, std::int64_t view);

/// CPU nanoseconds that threads spent on the stages after the render.
struct ImageTimes {
  std::atomic<std::int64_t> warp_ns = 0, develop_ns = 0, encode_ns = 0, write_ns = 0;
};

struct MadeImages {
  ViewRecord record;
  FrameExposure exposure = FrameExposure::good;
};

/// Makes the images of a rendered view and writes them below `root`, and the render itself if it is kept.
/// Several images are made at a time, each on one thread. Throws std::runtime_error in one line when a file
/// cannot be written; the view's other files are complete even then.
MadeImages make_images(const ViewImages& wanted, const RenderedHalves& halves,
                       const std::filesystem::path& root, ImageTimes& times);

}  // namespace cps
