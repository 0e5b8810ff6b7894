#pragma once

#include <filesystem>

namespace cps {

/// The folder of the recipes and models that come with the running program: ../share/cps relative to it, in
/// an installation and in the build tree alike. It need not exist.
std::filesystem::path share_folder();

}  // namespace cps
