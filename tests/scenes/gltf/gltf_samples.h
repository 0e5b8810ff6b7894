#pragma once

#include <vector>

/// Small valid .glb and .gltf files that together use most of what the importer reads.
std::vector<std::vector<unsigned char>> gltf_samples();
