#pragma once

#include <filesystem>

namespace cps {

/// Throws std::runtime_error as refuse_picture() does if the file is a DPX (SMPTE 268M) whose header
/// announces more user data than the file holds: OpenImageIO 2.4 ends the program on some of them. Other
/// files pass.
void check_dpx_header(const std::filesystem::path& file);

}  // namespace cps
