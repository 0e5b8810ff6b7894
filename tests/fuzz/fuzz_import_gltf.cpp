#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "renderer/geometry/geometry.h"
#include "renderer/lights/lamps.h"
#include "renderer/materials/material.h"
#include "renderer/memory_estimate.h"
#include "scenes/gltf_import.h"
#include "tests/fuzz/mutate_gltf.h"
#include "tests/scenes/gltf/gltf_maker.h"

namespace {

constexpr std::size_t max_decoded_bytes = std::size_t{256} << 20;

/// Whether a message is one short line that begins with the file's name.
bool is_good_refusal(const std::string& line, const std::string& file) {
  return line.starts_with(file + ": ") && line.find('\n') == line.npos && line.size() < file.size() + 420;
}

}  // namespace

/// Imports the bytes and builds the renderer's tables and lights from the scene: the renderer must handle
/// whatever the importer accepts.
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  static const TemporaryFolder folder;
  static const std::string file = (folder.path / "scene.glb").string();
  write_file(file, data, size);
  cps::Scene scene;
  try {
    scene = cps::import_gltf(file, max_decoded_bytes);
  } catch (const std::runtime_error& refusal) {
    if (is_good_refusal(refusal.what(), file)) return 0;
    std::fprintf(stderr, "refused with \"%s\"\n", refusal.what());
    std::abort();
  }
  cps::estimated_bytes(scene);
  const cps::Materials materials = cps::make_materials(scene, 1.0f);
  const cps::PlacedGeometry placed = cps::place_geometry(scene, materials);
  cps::make_lamps(scene, placed);
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(unsigned char* data, std::size_t size, std::size_t max_size,
                                               unsigned int seed) {
  return mutate_gltf(data, size, max_size, seed);
}
