#include "scenes/gltf/geometry/morphs.h"

#include <algorithm>

namespace cps::gltf {
namespace {

/// `values[i] += weight · displacement[i]`; a tangent's handedness stays.
template <int N, int M>
void add_displacements(PrimitiveReader& target, const std::string& name, float weight,
                       std::vector<Eigen::Matrix<float, M, 1>>& values) {
  if (values.empty()) return;
  const auto displacements = read_finite_attribute<N>(target, name);
  for (std::size_t i = 0; i < displacements.size(); ++i)
    values[i].template head<N>() += weight * displacements[i];
}

}  // namespace

std::vector<double> rest_weights(const Document& document, const tinygltf::Node& node) {
  const std::vector<double>& weights =
      node.weights.empty() ? document.model.meshes[node.mesh].weights : node.weights;
  if (std::all_of(weights.begin(), weights.end(), [](double weight) { return weight == 0; })) return {};
  return weights;
}

void apply_morph_targets(PrimitiveReader& reader, std::span<const double> weights, Mesh& mesh) {
  for (std::size_t i = 0; i < std::min(weights.size(), reader.primitive.targets.size()); ++i) {
    const auto weight = static_cast<float>(weights[i]);
    if (weight == 0) continue;
    tinygltf::Primitive displacements;
    displacements.attributes = reader.primitive.targets[i];
    PrimitiveReader target{reader.document, displacements,       reader.where + "." + element("targets", i),
                           reader.vertices, reader.vertex_count, reader.uv_names};
    add_displacements<3>(target, "POSITION", weight, mesh.positions);
    add_displacements<3>(target, "NORMAL", weight, mesh.normals);
    add_displacements<3>(target, "TANGENT", weight, mesh.tangents);
    add_displacements<2>(target, target.uv_names[0], weight, mesh.uv0);
    add_displacements<2>(target, target.uv_names[1], weight, mesh.uv1);
  }
}

}  // namespace cps::gltf
