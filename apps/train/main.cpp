#include <unistd.h>

#include <boost/program_options/errors.hpp>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "apps/train/verbs.h"

namespace {

/// OpenMP reads its variables while libraries load, before main. With its default, waiting threads spin,
/// which halves the speed of training as soon as anything else runs on the machine: so start over with the
/// other.
void make_idle_threads_sleep(char** argv) {
  if (std::getenv("OMP_WAIT_POLICY")) return;
  setenv("OMP_WAIT_POLICY", "passive", 1);
  execv("/proc/self/exe", argv);  // on failure: slower, nothing worse
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
  make_idle_threads_sleep(argv);
  return run(cps::Arguments(argv + 1, argv + argc));
} catch (const boost::program_options::error& error) {
  std::cerr << "cps-train: " << error.what() << "\n";
  return 2;
} catch (const std::exception& error) {
  const std::string what = error.what();
  std::cerr << "cps-train: " << what.substr(0, what.find('\n')) << "\n";  // LibTorch appends a back trace
  return 1;
}
