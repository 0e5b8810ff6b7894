#include <catch2/catch.hpp>
#include <stdexcept>

#include "random/counter_hash.h"
#include "scenes/gltf_import.h"
#include "tests/scenes/gltf/gltf_maker.h"
#include "tests/scenes/gltf/gltf_samples.h"

using Bytes = std::vector<unsigned char>;

namespace {

/// The file with a few bytes overwritten, flipped, removed or repeated, or with its end cut off.
Bytes mutated(const Bytes& original, cps::Stream stream) {
  Bytes bytes = original;
  std::uint64_t index = 0;
  const auto below = [&](std::uint64_t count) { return cps::random_below(stream, index++, count); };
  for (std::uint64_t left = 1 + below(2); left > 0 && !bytes.empty(); --left) {
    const std::size_t at = below(bytes.size()),
                      length = std::min<std::size_t>(1 + below(8), bytes.size() - at);
    switch (below(7)) {
      case 0:
        bytes[at] = static_cast<unsigned char>(below(256));
        break;
      case 1:
        bytes[at] ^= static_cast<unsigned char>(1u << below(8));
        break;
      case 2:
        bytes.erase(bytes.begin() + at, bytes.begin() + at + length);
        break;
      case 3: {
        const Bytes part(bytes.begin() + at, bytes.begin() + at + length);
        bytes.insert(bytes.begin() + at, part.begin(), part.end());
        break;
      }
      case 4:
        std::fill_n(bytes.begin() + at, length, below(2) ? 0xff : 0x00);
        break;
      case 5:  // changes a digit, since references and sizes are numbers in the JSON
        for (std::size_t i = at; i < bytes.size(); ++i)
          if (bytes[i] >= '0' && bytes[i] <= '9') {
            bytes[i] = static_cast<unsigned char>('0' + below(10));
            break;
          }
        break;
      default:
        if (below(10) == 0) bytes.resize(at);
    }
  }
  return bytes;
}

/// Checks what the rest of the program assumes of a scene.
bool is_valid_scene(const cps::Scene& scene) {
  const auto in = [](int index, std::size_t size) {
    return index >= 0 && static_cast<std::size_t>(index) < size;
  };
  bool sound = !scene.materials.empty() && !scene.instances.empty() && scene.bounds.min().allFinite() &&
               scene.bounds.max().allFinite();
  for (const cps::Instance& instance : scene.instances) sound &= in(instance.mesh, scene.meshes.size());
  for (const cps::Mesh& mesh : scene.meshes) {
    const std::size_t count = mesh.positions.size();
    sound &=
        in(mesh.material, scene.materials.size()) && mesh.normals.size() == count && mesh.uv0.size() == count;
    for (const std::size_t optional : {mesh.uv1.size(), mesh.tangents.size(), mesh.colors.size()})
      sound &= optional == 0 || optional == count;
    for (const Eigen::Vector3i& triangle : mesh.triangles)
      for (const int vertex : triangle) sound &= in(vertex, count);
    for (const Eigen::Vector3f& position : mesh.positions) sound &= position.allFinite();
    for (const Eigen::Vector3f& normal : mesh.normals) sound &= std::abs(normal.norm() - 1) < 1e-3f;
  }
  for (const cps::Material& material : scene.materials)
    for (const cps::TextureSlot* slot : cps::texture_slots(material))
      sound &= slot->texture == -1 || in(slot->texture, scene.textures.size());
  for (const cps::Texture& texture : scene.textures)
    sound &= texture.rgba.size() == std::size_t{4} * texture.width * texture.height;
  return sound;
}

}  // namespace

TEST_CASE("5,000 mutated files give valid scenes or are refused in one line") {
  const std::vector<Bytes> originals = gltf_samples();
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "mutated.glb";
  int imported = 0, refused = 0, faulty = 0;
  for (int i = 0; i < 5000; ++i) {
    const cps::Stream stream = cps::substream(cps::make_stream(1, "mutations"), i);
    const Bytes bytes = mutated(originals[i % originals.size()], stream);
    write_file(file, bytes.data(), bytes.size());
    try {
      const bool sound = is_valid_scene(cps::import_gltf(file));
      if (!sound) UNSCOPED_INFO("mutation " << i << " gave an invalid scene");
      faulty += !sound;
      ++imported;
    } catch (const std::runtime_error& error) {
      const std::string line = error.what();
      const bool good =
          line.starts_with(file.string() + ": ") && line.find('\n') == line.npos && line.size() < 600;
      if (!good) UNSCOPED_INFO("mutation " << i << " was refused with: " << line);
      faulty += !good;
      ++refused;
    }
  }
  CHECK(faulty == 0);
  // If either were rare, this test would prove little.
  CHECK(imported > 500);
  CHECK(refused > 500);
}
