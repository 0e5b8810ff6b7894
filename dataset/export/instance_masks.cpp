#include "dataset/export/instance_masks.h"

#include <map>

namespace cps {
namespace {

/// The values of a label of one channel, row by row.
std::vector<std::uint16_t> values_of(const OIIO::ImageBuf& label) {
  std::vector<std::uint16_t> values(label.spec().image_pixels());
  label.get_pixels(label.roi(), OIIO::TypeDesc::UINT16, values.data());
  return values;
}

/// A mask whose runs reach up to the pixel `end`.
struct Growing {
  InstanceMask mask;
  std::uint32_t end = 0;

  /// Adds the pixels from `first` to before `behind`, counted down the columns.
  void add(std::uint32_t first, std::uint32_t behind, int height) {
    mask.runs.push_back(first - end);
    mask.runs.push_back(behind - first);
    mask.area_px += behind - first;
    end = behind;
    const auto at = [&](std::uint32_t pixel) { return Eigen::Vector2i(pixel / height, pixel % height); };
    const Eigen::Vector2i top = at(first), bottom = at(behind - 1);
    mask.box.extend(top).extend(bottom);
    if (top.x() != bottom.x())
      mask.box.extend(Eigen::Vector2i(top.x(), height - 1)).extend(Eigen::Vector2i(bottom.x(), 0));
  }
};

}  // namespace

std::vector<InstanceMask> instance_masks(const OIIO::ImageBuf& instance, const OIIO::ImageBuf& semantic) {
  const std::vector<std::uint16_t> instances = values_of(instance), classes = values_of(semantic);
  const auto width = static_cast<std::uint32_t>(instance.spec().width);
  const auto height = static_cast<std::uint32_t>(instance.spec().height), pixels = width * height;
  const auto key_at = [&](std::uint32_t pixel) {
    const std::size_t i = std::size_t{pixel % height} * width + pixel / height;
    return std::pair(instances[i], classes[i]);
  };
  std::map<std::pair<std::uint16_t, std::uint16_t>, Growing> growing;
  for (std::uint32_t first = 0; first < pixels;) {
    const auto key = key_at(first);
    std::uint32_t behind = first + 1;
    while (behind < pixels && key_at(behind) == key) ++behind;
    if (key.first != 0) growing[key].add(first, behind, static_cast<int>(height));
    first = behind;
  }
  std::vector<InstanceMask> masks;
  for (auto& [key, grown] : growing) {
    if (grown.end < pixels) grown.mask.runs.push_back(pixels - grown.end);
    grown.mask.instance = key.first;
    grown.mask.class_id = key.second;
    masks.push_back(std::move(grown.mask));
  }
  return masks;
}

std::string compressed_runs(std::span<const std::uint32_t> runs) {
  constexpr int bits = 5, sign_bit = 1 << (bits - 1), goes_on = 1 << bits;
  std::string text;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::int64_t rest = runs[i];
    if (i > 2) rest -= runs[i - 2];
    for (bool is_last = false; !is_last;) {
      const auto group = static_cast<int>(rest & (goes_on - 1));
      rest >>= bits;
      is_last = rest == ((group & sign_bit) != 0 ? -1 : 0);
      text += static_cast<char>('0' + group + (is_last ? 0 : goes_on));
    }
  }
  return text;
}

}  // namespace cps
