#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "trainer/images/network_image.h"
#include "trainer/model/train_options.h"

namespace cps {

/// A picture file with the size that its calibration says.
struct SizedPicture {
  std::filesystem::path file;
  ImageSize size;
};

/// Pictures as a network takes them.
struct ReadPictures {
  std::vector<int> kept;             ///< which of the files these are, ascending
  std::vector<NetworkImage> images;  ///< of the kept files
  std::vector<std::string> skipped;  ///< one line for each of the others
};

/// Reads the pictures in parallel, as a network with these options takes them. Those that cannot be read, or
/// have another size, are skipped if `skip_bad`; otherwise throws std::runtime_error with one line about the
/// first.
ReadPictures read_pictures(std::span<const SizedPicture> pictures, const TrainOptions& options,
                           bool skip_bad);

}  // namespace cps
