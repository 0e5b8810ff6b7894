#include "dataset/verify/class_check.h"

#include <algorithm>

namespace cps {
namespace {

nlohmann::json classes_of_condition(const DatasetFiles& files, std::int64_t condition) {
  const nlohmann::json conditions = files.list("conditions");
  if (condition < 0 || condition >= static_cast<std::int64_t>(conditions.size()))
    return nlohmann::json::array();
  const std::string scene = conditions[static_cast<std::size_t>(condition)].value("scene", "");
  for (const nlohmann::json& entry : files.list("scenes"))
    if (entry.value("file", "") == scene) return entry.value("classes", nlohmann::json::array());
  return nlohmann::json::array();
}

}  // namespace

bool has_known_classes(const DatasetFiles& files, const FrameRow& frame, const OIIO::ImageBuf& semantic) {
  std::vector<bool> is_known(1 << 16);
  is_known[0] = true;
  for (const nlohmann::json& entry : classes_of_condition(files, frame.condition))
    is_known[entry.value("id", std::uint16_t{0})] = true;
  const auto* id = static_cast<const std::uint16_t*>(semantic.localpixels());
  return std::all_of(id, id + semantic.spec().image_pixels(), [&](std::uint16_t i) { return is_known[i]; });
}

}  // namespace cps
