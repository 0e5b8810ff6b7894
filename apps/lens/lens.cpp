#include <boost/program_options/errors.hpp>
#include <iostream>

#include "apps/lens/verbs.h"
#include "apps/manual/help_text.h"

namespace cps {
namespace {

const std::vector<Verb>& verbs() {
  static const std::vector<Verb> table = {
      verb_of(lens_limits_manual, cps_lens_limits), verb_of(lens_check_manual, cps_lens_check),
      verb_of(lens_convert_manual, cps_lens_convert), verb_of(lens_sample_manual, cps_lens_sample)};
  return table;
}

}  // namespace

const Manual& lens_manual() {
  static const Manual manual{
      .name = "cps lens",
      .summary = "compute limits of lenses, check and convert calibrations, draw lenses",
      .synopsis = {"limits [--size WxH,...] [--hfov DEG,...] [--csv] [-o PLOT.svg]",
                   "check CALIBRATION [--camera NAME]",
                   "convert CALIBRATION --to FAMILY [--camera NAME] -o FILE",
                   "sample N --size WxH --hfov DEG [--lens_draw SCHEME] [--seed S] [--json] [-o PLOT.svg]"},
      .description = R"(
limits and sample are about the lenses of datasets: k1 k2 k3 p1 p2 of the
Brown-Conrady model, from ideal to distorted coordinates, with OpenCV's order and
signs; k1 < 0 is barrel distortion. check and convert also know the families
rational, kannala_brandt (OpenCV's fisheye), unified_spherical, eucm and
double_sphere.

`cps help lens limits`, and so on, list the options.
)",
      .verbs = lines_of(verbs()),
      .exit_status = {{"0", "done, and every lens checked is one-to-one"},
                      {"1", "failed, or a lens is not one-to-one; stderr says why"},
                      {"2", "wrong usage"}},
      .see_also = {"cps lens limits", "cps lens check", "cps lens convert", "cps lens sample", "cps distort",
                   "cps undistort"},
  };
  return manual;
}

int cps_lens(const Arguments& arguments) {
  if (arguments.empty())
    throw boost::program_options::error(
        "lens: name one of limits, check, convert or sample; cps help lens describes them");
  const std::string& name = arguments.front();
  if (name == "--help" || name == "-h") {
    std::cout << help_text(lens_manual(), {});
    return 0;
  }
  if (print_page(arguments, lens_manual(), {})) return 0;
  for (const Verb& verb : verbs())
    if (name == verb.name) return verb.run(Arguments(arguments.begin() + 1, arguments.end()));
  throw boost::program_options::error("lens: '" + name + "' is none of limits, check, convert, sample");
}

}  // namespace cps
