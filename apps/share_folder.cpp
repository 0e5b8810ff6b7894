#include "apps/share_folder.h"

namespace cps {

std::filesystem::path share_folder() {
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe");
  return program.parent_path().parent_path() / "share" / "cps";
}

}  // namespace cps
