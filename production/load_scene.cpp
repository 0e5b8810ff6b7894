#include "production/load_scene.h"

namespace cps {

DrivenScene load_scene(const std::filesystem::path& file, const DriveOptions& options, const Watch& watch) {
  if (watch.is_stopped()) throw Interrupted();
  DrivenScene driven = load_driven_scene(file, options);
  if (!driven.note.empty()) watch.noted(driven.note);
  for (const std::string& warning : driven.scene.import_warnings)
    watch.warned(file.filename().string() + ": warning: " + warning);
  if (watch.scene_loaded) watch.scene_loaded(file, driven);
  return driven;
}

}  // namespace cps
