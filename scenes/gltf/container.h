#pragma once

#include <filesystem>

#include "scenes/gltf/document.h"

namespace cps::gltf {

/// Reads a .glb or .gltf file (told apart by content) with its external and data-URI buffers; every image
/// keeps the bytes of its file, undecoded. Sizes inside the container are checked here, references inside the
/// model are not.
Document read_document(const std::filesystem::path& file);

}  // namespace cps::gltf
