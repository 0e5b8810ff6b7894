#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/job/masters.h"
#include "distortion/warp/render_noise.h"
#include "trainer/images/blob_cache.h"

namespace cps {

/// A dataset's kept masters of one part, gray (Rec. 709 luminance, linear), ready to be warped.
struct MasterCache {
  std::vector<KeptMaster> masters;
  BlobCache pixels;                  ///< of each master: the picture's half floats, then the noise's
  std::vector<std::string> skipped;  ///< one line for each master left out

  /// Master i as floats of one channel.
  NoisyMaster gray(int i) const;
};

/// The masters of `part`, from `file` when it holds exactly these, else read (in parallel) and written there.
/// Those that are missing or cannot be read are left out, if they may; else BadBlobs is thrown. Throws
/// std::runtime_error with one line when the dataset keeps no masters or the part has none.
MasterCache load_master_cache(const std::filesystem::path& dataset, Part part, bool skip_bad,
                              const std::filesystem::path& file);

}  // namespace cps
