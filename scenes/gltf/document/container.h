#pragma once

#include <filesystem>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// Reads a .glb or .gltf file (told apart by content) with its external and data-URI buffers; images stay
/// encoded. Checks the sizes inside the container, but not the references inside the model. Refuses a file
/// whose JSON (parsed, up to 128 times its text) or whose external files together would take more than
/// `max_decoded_bytes`.
Document read_document(const std::filesystem::path& file, std::size_t max_decoded_bytes);

}  // namespace cps::gltf
