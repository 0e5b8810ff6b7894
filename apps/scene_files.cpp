#include "apps/scene_files.h"

#include <stdexcept>

#include "dataset/files.h"
#include "dataset/group_label.h"
#include "scenes/city/city.h"

namespace cps {

namespace fs = std::filesystem;

std::vector<fs::path> scene_files(const Recipe& recipe, const fs::path& city_folder) {
  std::vector<fs::path> files(recipe.scenes.begin(), recipe.scenes.end());
  for (const fs::path& file : files)
    if (!fs::is_regular_file(file))
      throw std::runtime_error("scene: " + file.string() + ": there is no such file");
  for (std::size_t i = 0; i < recipe.city_seeds.size(); ++i) {
    const CityOptions city{.seed = recipe.city_seeds[i],
                           .style = recipe.city_styles[i % recipe.city_styles.size()]};
    const fs::path file =
        city_folder / ("city_" + to_string(city.style) + "_" + std::to_string(city.seed) + ".glb");
    if (!fs::exists(file)) {
      fs::create_directories(city_folder);
      write_city(city, file);
    }
    files.push_back(file);
  }
  return files;
}

std::vector<std::string> scene_hashes(const std::vector<fs::path>& files) {
  std::vector<std::string> hashes;
  for (const fs::path& file : files) hashes.push_back(sha256(read_file(file)));
  return hashes;
}

std::string job_fingerprint(const std::string& wanted, const std::vector<std::string>& scene_sha256) {
  std::string job = generator_name() + "\n" + wanted;
  for (const std::string& hash : scene_sha256) job += hash + "\n";
  return sha256(job);
}

}  // namespace cps
