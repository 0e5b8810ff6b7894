#pragma once

#include <cstddef>

/// Changes the `size` bytes of a glTF file in place, which may grow to `max_size`: now and then anywhere,
/// else its JSON as a tree (numbers, names, references, copies of other parts) or its binary chunk, so that
/// most of what comes out still gets past the parser. The checksums of PNGs are mended, or their decoder
/// would never see a change. Returns the new size.
std::size_t mutate_gltf(unsigned char* bytes, std::size_t size, std::size_t max_size, unsigned int seed);
