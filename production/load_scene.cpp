#include "production/load_scene.h"

#include "files/files.h"
#include "files/png.h"
#include "scenes/drive/top_view.h"

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

std::function<void(const std::filesystem::path&, const DrivenScene&)> top_views_in(
    const std::filesystem::path& folder) {
  constexpr int max_side_px = 800;
  return [folder](const std::filesystem::path& scene_file, const DrivenScene& driven) {
    const std::string caption =
        driven.note.empty() ? scene_file.filename().string() + ": lanes of the file" : driven.note;
    write_file(folder / (scene_file.stem().string() + ".png"),
               encode_png(top_view(driven.scene, caption, max_side_px)));
  };
}

}  // namespace cps
