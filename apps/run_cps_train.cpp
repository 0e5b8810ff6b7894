#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "apps/verbs.h"

namespace cps {

int run_cps_train(const std::string& verb, const Arguments& arguments) {
  const std::filesystem::path program =
      std::filesystem::read_symlink("/proc/self/exe").parent_path() / "cps-train";
  if (!std::filesystem::exists(program))
    throw std::runtime_error("cps " + verb + ": " + program.string() +
                             " is missing; build or install the trainer (CPS_TRAINER=ON)");
  std::vector<std::string> words = {program.string(), verb};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  execv(program.c_str(), pointers.data());
  throw std::runtime_error(program.string() + ": cannot be run: " + std::strerror(errno));
}

}  // namespace cps
