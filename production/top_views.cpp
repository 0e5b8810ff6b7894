#include "production/top_views.h"

#include "files/files.h"
#include "files/png.h"
#include "scenes/drive/top_view.h"

namespace cps {

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
