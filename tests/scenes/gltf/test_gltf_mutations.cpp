#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <stdexcept>

#include "scenes/gltf_import.h"
#include "tests/fuzz/mutate_bytes.h"
#include "tests/fuzz/mutate_gltf.h"
#include "tests/scenes/gltf/gltf_maker.h"
#include "tests/scenes/gltf/gltf_samples.h"

using Bytes = std::vector<unsigned char>;

namespace {

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

/// What became of mutated files.
struct Outcomes {
  int imported = 0, refused = 0;
  int faulty = 0;  ///< invalid scenes, and refusals that are not one line that begins with the file's name
};

template <class Mutate>
Outcomes import_mutations(int count, std::size_t max_decoded_bytes, Mutate&& mutate) {
  const std::vector<Bytes> originals = gltf_samples();
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path / "mutated.glb";
  Outcomes outcomes;
  for (int i = 0; i < count; ++i) {
    const Bytes bytes = mutate(originals[i % originals.size()], i);
    write_file(file, bytes.data(), bytes.size());
    try {
      const bool sound = is_valid_scene(cps::import_gltf(file, max_decoded_bytes));
      if (!sound) UNSCOPED_INFO("mutation " << i << " gave an invalid scene");
      outcomes.faulty += !sound;
      ++outcomes.imported;
    } catch (const std::runtime_error& error) {
      const std::string line = error.what();
      const bool good =
          line.starts_with(file.string() + ": ") && line.find('\n') == line.npos && line.size() < 600;
      if (!good) UNSCOPED_INFO("mutation " << i << " was refused with: " << line);
      outcomes.faulty += !good;
      ++outcomes.refused;
    }
  }
  return outcomes;
}

}  // namespace

TEST_CASE("5,000 mutated files give valid scenes or are refused in one line") {
  const Outcomes outcomes = import_mutations(5000, std::size_t{1} << 30, [](const Bytes& original, int i) {
    return mutate_bytes(original, cps::substream(cps::make_stream(1, "mutations"), i));
  });
  CHECK(outcomes.faulty == 0);
  // If either were rare, this test would prove little.
  CHECK(outcomes.imported > 500);
  CHECK(outcomes.refused > 500);
}

TEST_CASE("100,000 files with values of their JSON mutated need less than 1 GiB", "[slow]") {
  const Outcomes outcomes =
      import_mutations(100'000, std::size_t{256} << 20, [](const Bytes& original, int i) {
        constexpr std::size_t max_size = 40'000;
        Bytes bytes = original;
        bytes.resize(std::max(original.size(), max_size));
        bytes.resize(mutate_gltf(bytes.data(), original.size(), bytes.size(), static_cast<unsigned>(i)));
        return bytes;
      });
  CHECK(outcomes.faulty == 0);
  CHECK(outcomes.imported > 10'000);
  CHECK(outcomes.refused > 10'000);
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  CHECK(used.ru_maxrss < 1 << 20);  // KiB
}
