#pragma once

#include <filesystem>

#include "scenes/gltf/document/document.h"

namespace cps::gltf {

/// Reads a .glb or .gltf file (told apart by content) with its external and data-URI buffers; every image
/// keeps the bytes of its file, undecoded. Sizes inside the container are checked here, references inside the
/// model are not. Neither the JSON, whose tree may become a hundred times its text, nor all files beside it
/// together may lead beyond `max_decoded_bytes`.
Document read_document(const std::filesystem::path& file, std::size_t max_decoded_bytes);

}  // namespace cps::gltf
