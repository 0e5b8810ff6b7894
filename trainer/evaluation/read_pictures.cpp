#include "trainer/evaluation/read_pictures.h"

#include <tbb/parallel_for.h>

#include <optional>
#include <stdexcept>
#include <utility>

namespace cps {

ReadPictures read_pictures(std::span<const SizedPicture> pictures, const TrainOptions& options,
                           bool skip_bad) {
  std::vector<std::optional<NetworkImage>> read(pictures.size());
  std::vector<std::string> failures(pictures.size());
  tbb::parallel_for(std::size_t{0}, pictures.size(), [&](std::size_t i) {
    try {
      const auto& [file, size] = pictures[i];
      const GrayImage gray = read_gray_image(file);
      if (gray.size != size)
        throw std::runtime_error(file.string() + ": is " + std::to_string(gray.size.width) + "x" +
                                 std::to_string(gray.size.height) + ", but its calibration is of " +
                                 std::to_string(size.width) + "x" + std::to_string(size.height) + " pixels");
      read[i] = network_image(gray, options.reduction, options.orientation);
    } catch (const std::exception& error) {
      failures[i] = error.what();
    }
  });
  ReadPictures result;
  for (std::size_t i = 0; i < read.size(); ++i) {
    if (!read[i] && !skip_bad) throw std::runtime_error(failures[i]);
    if (!read[i]) {
      result.skipped.push_back(failures[i]);
      continue;
    }
    result.kept.push_back(static_cast<int>(i));
    result.images.push_back(std::move(*read[i]));
  }
  return result;
}

}  // namespace cps
