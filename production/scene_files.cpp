#include "production/scene_files.h"

#include <stdexcept>

#include "files/file_lock.h"
#include "files/files.h"
#include "scenes/drive/file_frame.h"
#include "scenes/ego_bonnet.h"
#include "scenes/gltf_import.h"

namespace cps {

namespace fs = std::filesystem;

namespace {

/// Makes the missing cities. Those that another process is making it skips or, with `wait`, waits for.
void make_missing_cities(const std::vector<PlannedScene>& scenes, const fs::path& lock_folder, bool wait) {
  for (const PlannedScene& scene : scenes) {
    if (!scene.city || fs::exists(scene.file)) continue;
    const FileLock lock(lock_folder / (scene.file.filename().string() + ".lock"), FileLock::Kind::exclusive,
                        wait);
    if (!lock.is_held() || fs::exists(scene.file)) continue;
    write_by_rename(scene.file, [&](const fs::path& temporary) { write_city(*scene.city, temporary); });
  }
}

}  // namespace

void require_given_files(const std::vector<PlannedScene>& scenes) {
  for (const PlannedScene& scene : scenes)
    if (!scene.city && !fs::is_regular_file(scene.file))
      throw std::runtime_error("scene: " + scene.file.string() + ": there is no such file");
}

void make_scene_files(const std::vector<PlannedScene>& scenes, const fs::path& lock_folder) {
  require_given_files(scenes);
  for (bool wait : {false, true}) make_missing_cities(scenes, lock_folder, wait);
}

Scene load_scene(const PlannedScene& planned, const Recipe& recipe) {
  Scene scene = import_gltf(planned.file);
  if (planned.is_z_up) turn_z_up(scene);
  scale_scene(scene, planned.metres_per_unit);
  if (recipe.ego_bonnet) add_ego_bonnet(scene);
  return scene;
}

}  // namespace cps
