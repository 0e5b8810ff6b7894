#include <boost/program_options/errors.hpp>
#include <csignal>
#include <exception>
#include <iostream>

#include "apps/manual/help_text.h"
#include "apps/train/summaries.h"
#include "apps/verbs.h"
#include "apps/version.h"

namespace {

using cps::Arguments;
using cps::Manual;
using cps::Verb;
using cps::verb_of;

/// A verb of cps-train.
Verb trained(const Manual::Line& verb) {
  return {.name = verb.name,
          .summary = verb.text,
          .run = [name = verb.name](const Arguments& rest) { return cps::run_cps_train(name, rest); },
          .program = "cps-train"};
}

const std::vector<Verb>& verbs() {
  static const std::vector<Verb> table = {
      verb_of(cps::city_manual, cps::cps_city),
      verb_of(cps::render_manual, cps::cps_render),
      verb_of(cps::plan_manual, cps::cps_plan),
      verb_of(cps::generate_manual, cps::cps_generate),
      verb_of(cps::finish_manual, cps::cps_finish),
      verb_of(cps::verify_manual, cps::cps_verify),
      verb_of(cps::contact_sheet_manual, cps::cps_contact_sheet),
      verb_of(cps::export_manual, cps::cps_export),
      verb_of(cps::report_manual, cps::cps_report),
      verb_of(cps::migrate_manual, cps::cps_migrate),
      verb_of(cps::lens_manual(), cps::cps_lens),
      verb_of(cps::distort_manual, cps::cps_distort),
      verb_of(cps::undistort_manual, cps::cps_undistort),
      verb_of(cps::relens_manual, cps::cps_relens),
      trained(cps::train_line),
      trained(cps::eval_line),
      trained(cps::predict_line),
  };
  return table;
}

std::vector<std::string> see_also() {
  std::vector<std::string> names{"cps-slurm"};
  for (const Verb& verb : verbs()) names.push_back("cps " + verb.name);
  return names;
}

const Manual& manual() {
  static const Manual text{
      .name = "cps",
      .summary = "training data for camera calibration",
      .synopsis = {"VERB [options]", "help VERB", "--version"},
      .description = R"(
Path-traces city streets from a camera on a car, shows every render through many
Brown-Conrady lenses, and writes images with exact labels; trains networks on
them that read a camera's field of view and lens distortion from one image.

cps help VERB describes a verb and its options. Option names may be written with
- or _: --max-zoom is --max_zoom. -o, --out and --output name the output in every
verb. An error is one line that names the file, the field and the fix.
)",
      .verbs = cps::lines_of(verbs()),
      .exit_status = {{"0", "done"},
                      {"1", "failed"},
                      {"2", "wrong usage"},
                      {"75", "interrupted: run it again"}},
      .examples = {{"cps generate --recipe demo --out data", "makes a small dataset"},
                   {"cps verify data", "checks every file of it"},
                   {"cps train --data data --out model --preset demo", "trains a network on it"}},
      .see_also = see_also(),
  };
  return text;
}

int run(Arguments arguments) {
  if (arguments.empty()) {
    std::cerr << cps::help_text(manual(), {});
    return 2;
  }
  if (cps::print_pages(arguments, manual(), verbs())) return 0;
  std::string name = arguments.front();
  arguments.erase(arguments.begin());
  if (name == "--version") {
    std::cout << "cps " CPS_VERSION " (commit " << cps::source_commit << ")\n";
    return 0;
  }
  if (name == "help" || name == "--help" || name == "-h") {
    if (arguments.empty()) {
      std::cout << cps::help_text(manual(), {});
      return 0;
    }
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
