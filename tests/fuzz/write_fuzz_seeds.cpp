#include <filesystem>
#include <iostream>

#include "tests/scenes/gltf/gltf_maker.h"
#include "tests/scenes/gltf/gltf_samples.h"

/// write_fuzz_seeds FOLDER: writes the files that fuzzing starts from.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_fuzz_seeds FOLDER\n";
    return 2;
  }
  std::filesystem::create_directories(argv[1]);
  int number = 0;
  for (const std::vector<unsigned char>& bytes : gltf_samples())
    write_file(std::filesystem::path(argv[1]) / ("sample" + std::to_string(number++)), bytes.data(),
               bytes.size());
}
