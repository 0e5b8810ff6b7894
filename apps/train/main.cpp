#include <unistd.h>

#include <boost/program_options/errors.hpp>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "apps/train/verbs.h"

namespace {

/// What libraries read while they load, before main; so it is set by starting over.
constexpr const char* settings[][2] = {
    // By OpenMP's default, waiting threads spin, which halves the speed of training as soon as anything else
    // runs on the machine.
    {"OMP_WAIT_POLICY", "passive"},
    // Each step needs the memory of the one before: by default glibc gives it back to the system in between,
    // which clears it page by page.
    {"GLIBC_TUNABLES",
     "glibc.malloc.hugetlb=1:glibc.malloc.mmap_max=0:glibc.malloc.trim_threshold=17179869184"},
};

void start_over_with_settings(char** argv) {
  bool is_new = false;
  for (const auto& [name, value] : settings) {
    if (std::getenv(name)) continue;
    setenv(name, value, 1);
    is_new = true;
  }
  if (is_new) execv("/proc/self/exe", argv);  // on failure: slower, nothing worse
}

int usage(std::ostream& out, int status) {
  out << "cps-train: the trainer of cps (cps train, eval and predict run it)\n\n"
         "Usage: cps-train VERB [options]; cps-train VERB --help says more.\n\n"
         "  train     train a network on a dataset\n"
         "  eval      measure a trained network on a dataset\n"
         "  predict   what a trained network says of images\n\n"
         "Exit status: 0 done, 1 failed, 2 wrong usage.\n";
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
  start_over_with_settings(argv);
  return run(cps::Arguments(argv + 1, argv + argc));
} catch (const boost::program_options::error& error) {
  std::cerr << "cps-train: " << error.what() << "\n";
  return 2;
} catch (const std::exception& error) {
  const std::string what = error.what();
  std::cerr << "cps-train: " << what.substr(0, what.find('\n')) << "\n";  // LibTorch appends a back trace
  return 1;
}
