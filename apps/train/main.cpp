#include <unistd.h>

#include <boost/program_options/errors.hpp>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "apps/train/verbs.h"

namespace {

/// Environment variables that libraries read while they load, before main(): set by executing this program
/// again.
constexpr const char* settings[][2] = {
    // OpenMP's waiting threads spin by default, which halves the speed of training as soon as anything else
    // runs on the machine.
    {"OMP_WAIT_POLICY", "passive"},
    // Each step reuses the memory of the one before. By default glibc returns it to the system in between,
    // which then clears it page by page.
    {"GLIBC_TUNABLES",
     "glibc.malloc.hugetlb=1:glibc.malloc.mmap_max=0:glibc.malloc.trim_threshold=17179869184"},
};

void restart_with_settings(char** argv) {
  bool is_new = false;
  for (const auto& [name, value] : settings) {
    if (std::getenv(name)) continue;
    setenv(name, value, 1);
    is_new = true;
  }
  if (is_new) execv("/proc/self/exe", argv);  // if it fails: slower, but correct
}

int usage(std::ostream& out, int status) {
  out << R"(cps-train: the trainer of cps (cps train, eval and predict run it)

Usage: cps-train VERB [options]; cps-train VERB --help lists the options.

  train     train a network on a dataset
  eval      measure a trained network on a dataset
  predict   run a trained network on images

Exit status: 0 done, 1 failed, 2 wrong usage.
)";
  return status;
}

int run(const cps::Arguments& words) {
  if (words.empty()) return usage(std::cerr, 2);
  const cps::Arguments arguments(words.begin() + 1, words.end());
  if (words[0] == "train") return cps::train_verb(arguments);
  if (words[0] == "eval") return cps::eval_verb(arguments);
  if (words[0] == "predict") return cps::predict_verb(arguments);
  if (words[0] == "help" || words[0] == "--help" || words[0] == "-h") return usage(std::cout, 0);
  if (words[0] == "--version") {
    std::cout << "cps-train " CPS_VERSION "\n";
    return 0;
  }
  std::cerr << "cps-train: '" << words[0] << "' is not a verb; cps-train help lists them\n";
  return 2;
}

}  // namespace

int main(int argc, char** argv) try {
  restart_with_settings(argv);
  return run(cps::Arguments(argv + 1, argv + argc));
} catch (const boost::program_options::error& error) {
  std::cerr << "cps-train: " << error.what() << "\n";
  return 2;
} catch (const std::exception& error) {
  const std::string what = error.what();
  std::cerr << "cps-train: " << what.substr(0, what.find('\n')) << "\n";  // LibTorch appends a back trace
  return 1;
}
