#include <boost/program_options/errors.hpp>
#include <csignal>
#include <exception>
#include <functional>
#include <iostream>

#include "apps/verbs.h"

namespace {

using cps::Arguments;

struct Verb {
  const char* name;
  const char* summary;
  std::function<int(const Arguments&)> run;
};

const std::vector<Verb>& verbs() {
  const auto train = [](const char* verb) {
    return [verb](const Arguments& arguments) { return cps::run_cps_train(verb, arguments); };
  };
  static const std::vector<Verb> table = {
      {"city", "make a procedural city, a .glb, from a seed", cps::cps_city},
      {"render", "render one view of a glTF scene", cps::cps_render},
      {"plan", "estimate what a recipe makes and costs", cps::cps_plan},
      {"generate", "make a dataset from a recipe, or resume one", cps::cps_generate},
      {"finish", "join the shards of a dataset", cps::cps_finish},
      {"verify", "check every file of a dataset against its labels", cps::cps_verify},
      {"contact-sheet", "draw views of a dataset through their lenses, in one picture",
       cps::cps_contact_sheet},
      {"export", "write a dataset in the layout that another program reads", cps::cps_export},
      {"report", "describe a dataset on one HTML page", cps::cps_report},
      {"lens", "compute limits of lenses, check a calibration, draw lenses", cps::cps_lens},
      {"distort", "show ideal pictures through a lens, with labels", cps::cps_distort},
      {"undistort", "straighten pictures taken through a lens", cps::cps_undistort},
      {"relens", "make a test set from real pictures, through many lenses", cps::cps_relens},
      {"train", "train a network on a dataset", train("train")},
      {"eval", "measure a trained network on a dataset", train("eval")},
      {"predict", "run a trained network on pictures", train("predict")},
  };
  return table;
}

int usage(std::ostream& out) {
  out << "cps: training data for camera calibration\n\n"
         "Usage: cps VERB [options]\n\n";
  for (const Verb& verb : verbs())
    out << "  " << verb.name << std::string(16 - std::string(verb.name).size(), ' ') << verb.summary << "\n";
  out << R"(
cps help VERB describes a verb and its options. Option names may be written with
- or _: --max-zoom is --max_zoom.

Exit status: 0 done, 1 failed, 2 wrong usage, 75 interrupted: run it again.
)";
  return 0;
}

int run(Arguments arguments) {
  if (arguments.empty()) {
    usage(std::cerr);
    return 2;
  }
  std::string name = arguments.front();
  arguments.erase(arguments.begin());
  if (name == "--version") {
    std::cout << "cps " CPS_VERSION "\n";
    return 0;
  }
  if (name == "help" || name == "--help" || name == "-h") {
    if (arguments.empty()) return usage(std::cout);
    name = arguments.front();
    arguments.erase(arguments.begin());
    arguments.push_back("--help");
  }
  for (const Verb& verb : verbs())
    if (name == verb.name) return verb.run(arguments);
  std::cerr << "cps: '" << name << "' is not a verb; cps help lists the verbs\n";
  return 2;
}

}  // namespace

int main(int argc, char** argv) try {
  std::signal(SIGXFSZ, SIG_IGN);  // so that a file over the size limit is an error, like a full disk
  return run(Arguments(argv + 1, argv + argc));
} catch (const boost::program_options::error& error) {
  std::cerr << "cps: " << error.what() << "\n";
  return 2;
} catch (const std::exception& error) {
  std::cerr << "cps: " << error.what() << "\n";
  return 1;
}
