#pragma once

#include <cstddef>

/// Mutates a glTF file of `size` bytes in place, up to `max_size` bytes, and returns its new size. Mostly
/// changes values of the JSON tree (numbers, names, references, copies of subtrees) or of the binary chunk,
/// so that most results get past the parser; sometimes changes any bytes. Repairs PNG checksums, or the PNG
/// decoder would never see a change.
std::size_t mutate_gltf(unsigned char* bytes, std::size_t size, std::size_t max_size, unsigned int seed);
