#pragma once

#include <filesystem>
#include <string_view>

namespace cps {

/// Writes a whole file under a temporary name beside it and renames it: no reader ever sees half of it.
/// Throws std::runtime_error with one line that names the file.
void write_atomically(const std::filesystem::path& file, std::string_view bytes);

}  // namespace cps
