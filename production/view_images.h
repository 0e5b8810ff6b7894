#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
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
  Stream sensor;                          ///< of its settings and noise
  std::optional<ModelCamera> model = {};  ///< a camera of another family, in place of `lens`

  /// The camera and its lens.
  ModelCamera camera() const { return model ? *model : ModelCamera{{}, lens.camera, lens.distortion}; }
};

/// All that is made of one view's render.
struct ViewImages {
  std::int64_t view = 0;  ///< index into Plan::views
  Pinhole master;         ///< the render's camera; empty where images are traced
  std::vector<PlannedImage> images;
  std::string master_file = {};  ///< relative to the dataset; empty: the render is not kept
  SensorOptions sensor;
  ImageFormat format = ImageFormat::png;
  int jpeg_quality = 95;

  /// Whether images are traced through their lenses, which are of another family than Brown–Conrady.
  bool are_traced() const { return !images.empty() && images.front().model; }
};

/// The pixels that render_view() renders.
double rendered_pixels(const ViewImages& wanted);

/// Renders what the wanted images are made of: the master, or the images themselves. See render_halves().
RenderedView render_view(const Recipe& recipe, const PlannedView& view, const ViewImages& wanted,
                         LitScene& lit, const TileProgress& progress = {});

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

/// Makes the images of a rendered view and writes them below `root`, and the render itself if it is kept. All
/// share one exposure: metered on the master or, of traced images, on the valid pixels of all of them, beside
/// which they are black (valid_mask.h). Several images are made at a time, each on one thread. Throws
/// std::runtime_error in one line when a file cannot be written; the view's other files are complete even
/// then.
MadeImages make_images(const ViewImages& wanted, const RenderedView& rendered,
                       const std::filesystem::path& root, ImageTimes& times);

}  // namespace cps
