#include "apps/scene_files.h"

#include <stdexcept>

#include "dataset/files.h"
#include "dataset/group_label.h"
#include "scenes/drive/unit_scale.h"
#include "scenes/ego_bonnet.h"
#include "scenes/gltf_import.h"

namespace cps {

namespace fs = std::filesystem;

void make_scene_files(const std::vector<PlannedScene>& scenes) {
  for (const PlannedScene& scene : scenes)
    if (!scene.city && !fs::is_regular_file(scene.file))
      throw std::runtime_error("scene: " + scene.file.string() + ": there is no such file");
  for (const PlannedScene& scene : scenes) {
    if (!scene.city || fs::exists(scene.file)) continue;
    fs::create_directories(scene.file.parent_path());
    write_city(*scene.city, scene.file);
  }
}

Scene load_scene(const PlannedScene& planned, const Recipe& recipe) {
  Scene scene = import_gltf(planned.file);
  scale_scene(scene, planned.metres_per_unit);
  if (recipe.ego_bonnet) add_ego_bonnet(scene);
  return scene;
}

std::vector<std::string> scene_hashes(const std::vector<PlannedScene>& scenes) {
  std::vector<std::string> hashes;
  for (const PlannedScene& scene : scenes) hashes.push_back(sha256(read_file(scene.file)));
  return hashes;
}

std::string job_fingerprint(const std::string& wanted, const std::vector<std::string>& scene_sha256) {
  std::string job = generator_name() + "\n" + wanted;
  for (const std::string& hash : scene_sha256) job += hash + "\n";
  return sha256(job);
}

}  // namespace cps
