#include "scenes/gltf/document/data_uris.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace cps::gltf {

void complete_data_uris(nlohmann::json& root) {
  constexpr std::string_view general = "data:application/octet-stream;base64,";
  constexpr std::array known = {general, std::string_view("data:image/png;base64,"),
                                std::string_view("data:image/jpeg;base64,"),
                                std::string_view("data:application/gltf-buffer;base64,")};
  for (const char* list : {"buffers", "images"}) {
    const auto found = root.find(list);
    if (found == root.end() || !found->is_array()) continue;
    for (nlohmann::json& item : *found) {
      const auto uri = item.find("uri");
      if (uri == item.end() || !uri->is_string()) continue;
      auto& text = uri->get_ref<std::string&>();
      const auto begins = [&](std::string_view header) { return text.starts_with(header); };
      if (!begins("data:") || std::any_of(known.begin(), known.end(), begins)) continue;
      const std::size_t comma = text.find(',');
      if (comma == text.npos || !std::string_view(text).substr(0, comma).ends_with(";base64")) continue;
      text.replace(0, comma + 1, general);
    }
  }
}

}  // namespace cps::gltf
