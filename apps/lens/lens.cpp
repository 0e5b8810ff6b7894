#include <array>
#include <boost/program_options/errors.hpp>
#include <iostream>

#include "apps/lens/verbs.h"

namespace cps {
namespace {

struct Subverb {
  const char* name;
  int (*run)(const Arguments&);
};
constexpr std::array<Subverb, 3> subverbs{
    {{"limits", cps_lens_limits}, {"check", cps_lens_check}, {"sample", cps_lens_sample}}};

constexpr const char* manual =
    R"(cps lens: compute limits of lenses, check a calibration, draw lenses

Usage:
  cps lens limits [--size WxH,...] [--hfov DEG,...] [--csv] [-o PLOT.svg]
  cps lens check CALIBRATION [--camera NAME]
  cps lens sample N --size WxH --hfov DEG [--lens_draw SCHEME] [--seed S]
                  [--json] [-o PLOT.svg]

A lens is the k1 k2 k3 p1 p2 of the Brown-Conrady model, from ideal to distorted
coordinates, with OpenCV's order and signs: k1 < 0 is barrel distortion.

limits   Computes how far each coefficient may go while the others are 0, for
         each image size and H-FOV: the roots at which the lens meets a bound.
         Prints a table or CSV, and draws a plot.

check    Proves that a calibration maps its whole frame one-to-one, or says
         where it does not. Prints the true angles of view, how exactly the
         lens is inverted, and where common iterative inverses fail on it.
         Reads cps' calibration.json, OpenCV's YAML and XML, COLMAP's
         cameras.txt, ROS' camera_info, KITTI's calib_cam_to_cam.txt, Kalibr's
         camchain and nerfstudio's transforms.json.

sample   Draws N lenses as `cps generate` does, and prints them with the
         principal point and H-FOV left after the crop, as CSV or JSON. Draws a
         plot.

`cps help lens limits`, and so on, list the options.

Exit status: 0 done, and every lens checked is one-to-one; 1 failed, or a lens
is not one-to-one (stderr says why); 2 wrong usage.
)";

}  // namespace

int cps_lens(const Arguments& arguments) {
  if (arguments.empty())
    throw boost::program_options::error(
        "lens: name one of limits, check or sample; cps help lens describes them");
  const std::string& name = arguments.front();
  if (name == "--help" || name == "-h") {
    std::cout << manual;
    return 0;
  }
  for (const Subverb& subverb : subverbs)
    if (name == subverb.name) return subverb.run(Arguments(arguments.begin() + 1, arguments.end()));
  throw boost::program_options::error("lens: '" + name + "' is none of limits, check, sample");
}

}  // namespace cps
