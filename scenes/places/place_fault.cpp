#include "scenes/places/place_fault.h"

namespace cps {

std::string to_string(PlaceFault fault) {
  switch (fault) {
    case PlaceFault::inside:
      return "inside";
    case PlaceFault::too_close:
      return "too_close";
    case PlaceFault::only_sky:
      return "only_sky";
    case PlaceFault::dark:
      return "dark";
    case PlaceFault::blown_out:
      return "blown_out";
    case PlaceFault::none:
      break;
  }
  return "none";
}

}  // namespace cps
