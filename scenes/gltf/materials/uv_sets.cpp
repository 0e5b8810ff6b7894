#include "scenes/gltf/materials/uv_sets.h"

#include <algorithm>
#include <vector>

namespace cps::gltf {
std::array<int, 2> choose_uv_sets(Document& document, Material& material, const std::string& where) {
  std::vector<int> used;
  for (const TextureSlot* slot : texture_slots(material))
    if (slot->texture != -1 && std::ranges::find(used, slot->uv_set) == used.end())
      used.push_back(slot->uv_set);
  if (std::ranges::all_of(used, [](int set) { return set <= 1; })) return {0, 1};
  if (used.size() > 2)
    warn(document, where + ": uses " + std::to_string(used.size()) +
                       " sets of texture coordinates, of which only TEXCOORD_" + std::to_string(used[0]) +
                       " and TEXCOORD_" + std::to_string(used[1]) + " are read");
  for (TextureSlot* slot : texture_slots(material))
    slot->uv_set = used.size() > 1 && slot->uv_set == used[1] ? 1 : 0;
  return {used[0], used.size() > 1 ? used[1] : used[0] + 1};
}

}  // namespace cps::gltf
