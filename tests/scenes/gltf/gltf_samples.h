#pragma once

#include <vector>

/// Small valid files, .glb and .gltf, that between them use most of what the importer reads.
std::vector<std::vector<unsigned char>> gltf_samples();
