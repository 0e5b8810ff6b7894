#include <unistd.h>

#include <boost/program_options/errors.hpp>
#include <cstdlib>
#include <exception>
#include <iostream>

#include "apps/manual/help_text.h"
#include "apps/train/verbs.h"
#include "apps/version.h"

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

const std::vector<cps::Verb>& verbs() {
  static const std::vector<cps::Verb> table = {cps::verb_of(cps::train_manual, cps::train_verb),
                                               cps::verb_of(cps::eval_manual, cps::eval_verb),
                                               cps::verb_of(cps::predict_manual, cps::predict_verb)};
  return table;
}

const cps::Manual& manual() {
  static const cps::Manual text{
      .name = "cps-train",
      .summary = "the trainer of cps (cps train, eval and predict run it)",
      .synopsis = {"VERB [options]", "help", "--version"},
      .description = "cps-train VERB --help lists the options of a verb.",
      .verbs = cps::lines_of(verbs()),
  };
  return text;
}

int run(const cps::Arguments& words) {
  if (words.empty()) {
    std::cerr << cps::help_text(manual(), {});
    return 2;
  }
  if (cps::print_pages(words, manual(), verbs())) return 0;
  for (const cps::Verb& verb : verbs())
    if (words[0] == verb.name) return verb.run(cps::Arguments(words.begin() + 1, words.end()));
  if (words[0] == "help" || words[0] == "--help" || words[0] == "-h") {
    std::cout << cps::help_text(manual(), {});
    return 0;
  }
  if (words[0] == "--version") {
    std::cout << "cps-train " CPS_VERSION " (commit " << cps::source_commit << ")\n";
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
