#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "dataset/job/masters.h"
#include "sensor/photograph.h"
#include "trainer/images/blob_cache.h"

namespace cps {

/// A dataset's kept masters of one part, linear, ready to be photographed.
struct MasterCache {
  std::vector<KeptMaster> masters;
  int channels = 3;                  ///< three, or one of luminance
  BlobCache pixels;                  ///< of each master: the picture's half floats, then the noise's
  std::vector<std::string> skipped;  ///< one line for each master left out

  /// Master i, in floats.
  Master master(int i) const;
};

/// The masters of a share of the part's places (share_of_places()), from `file` when it holds exactly these,
/// else read (in parallel) and written there: 4 bytes per master pixel and channel. Of masters kept as
/// luminance, one channel, only gray images can be made. Those that are missing or cannot be read are left
/// out if `skip_bad`; otherwise BadBlobs is thrown. Throws std::runtime_error with one line when the dataset
/// keeps no masters or the part has none.
MasterCache load_master_cache(const std::filesystem::path& dataset, Part part, bool as_luminance,
                              bool skip_bad, const std::filesystem::path& file, double places_share = 1);

}  // namespace cps
