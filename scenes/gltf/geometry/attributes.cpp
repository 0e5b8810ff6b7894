#include "scenes/gltf/geometry/attributes.h"

namespace cps::gltf {

std::vector<Eigen::Vector4f> read_colors(PrimitiveReader& reader) {
  const std::vector<tinygltf::Accessor>& accessors = reader.document.model.accessors;
  const auto found = reader.primitive.attributes.find("COLOR_0");
  if (found == reader.primitive.attributes.end() || !in_range(found->second, accessors))
    return read_attribute<4>(reader, "COLOR_0");
  const tinygltf::Accessor& colors = accessors[found->second];
  if (colors.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT && !colors.normalized)
    refuse(reader.document, reader.where + ".COLOR_0", "integer colours must be normalized");
  if (colors.type != TINYGLTF_TYPE_VEC3) return read_finite_attribute<4>(reader, "COLOR_0");
  std::vector<Eigen::Vector4f> with_alpha;
  for (const Eigen::Vector3f& color : read_finite_attribute<3>(reader, "COLOR_0"))
    with_alpha.emplace_back(color.x(), color.y(), color.z(), 1.0f);
  return with_alpha;
}

}  // namespace cps::gltf
