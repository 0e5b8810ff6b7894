#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

/// COCO's compressed masks, read as its description says, apart from the product's writer.
namespace cps {

/// The lengths of the runs.
inline std::vector<std::int64_t> coco_runs(const std::string& counts) {
  std::vector<std::int64_t> runs;
  for (std::size_t i = 0; i < counts.size();) {
    std::int64_t value = 0, weight = 1;
    int group = 32;
    for (; group >= 32; weight *= 32) {
      group = counts.at(i++) - '0';
      if (group < 0 || group > 63) throw std::runtime_error("no character of a compressed mask");
      value += weight * (group % 32);
    }
    if (group >= 16) value -= weight;  // the last group's highest bit is the sign
    if (runs.size() > 2) value += runs[runs.size() - 2];
    runs.push_back(value);
  }
  return runs;
}

/// The mask, row by row, from its runs down the columns. Throws when they do not fill it.
inline std::vector<bool> coco_mask(const std::vector<std::int64_t>& runs, std::size_t width,
                                   std::size_t height) {
  std::vector<bool> mask(width * height);
  std::size_t at = 0;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (runs[r] < 0 || (runs[r] == 0 && r > 0)) throw std::runtime_error("a run without pixels");
    for (std::int64_t i = 0; i < runs[r]; ++i, ++at) mask.at(at % height * width + at / height) = r % 2 == 1;
  }
  if (at != mask.size()) throw std::runtime_error("runs that end before the image");
  return mask;
}

inline std::vector<bool> coco_mask(const nlohmann::json& segmentation) {
  return coco_mask(coco_runs(segmentation.at("counts")), segmentation.at("size").at(1),
                   segmentation.at("size").at(0));
}

}  // namespace cps
