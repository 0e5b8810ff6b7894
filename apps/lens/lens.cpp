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
    R"(cps lens: which lenses there are, and whether one can be trusted

Usage:
  cps lens limits [--size WxH,...] [--hfov DEG,...] [--csv] [-o PLOT.svg]
  cps lens check CALIBRATION [--camera NAME]
  cps lens sample N --size WxH --hfov DEG [--lens_draw SCHEME] [--seed S]
                  [--json] [-o PLOT.svg]

A lens is the k1 k2 k3 p1 p2 of Brown and Conrady, from ideal to distorted, in
OpenCV's order and signs: k1 < 0 is barrel.

limits   How far each coefficient may go, the others 0, per image size and
         H-FOV: the roots at which a bound is met. A table or CSV, and a plot.

check    Whether a calibration maps its whole frame one-to-one, proved; the
         angles it really sees; how exactly it is inverted, and where the usual
         iterations go wrong on it. Reads cps' calibration.json, OpenCV's YAML
         and XML, COLMAP's cameras.txt, ROS' camera_info, KITTI's
         calib_cam_to_cam.txt, Kalibr's camchain and nerfstudio's
         transforms.json. All cameras of the file, or one.

sample   N lenses as `cps generate` draws them, with the principal point and the
         H-FOV that are left after the crop: CSV or JSON, and a plot.

cps lens limits --help, and so on, list the options.

Exit status: 0 done, and every lens checked is one-to-one; 1 failed, or a lens
is not one-to-one, and a line says why; 2 wrong usage.
)";

}  // namespace

int cps_lens(const Arguments& arguments) {
  if (arguments.empty())
    throw boost::program_options::error("lens: say limits, check or sample; cps help lens says more");
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
