#include "sampler/part.h"

#include <stdexcept>

namespace cps {

std::string to_string(Part part) {
  switch (part) {
    case Part::train:
      return "train";
    case Part::val:
      return "val";
    case Part::test:
      return "test";
    case Part::all:
      break;
  }
  return "all";
}

Part part_from_string(const std::string& word) {
  for (Part part : {Part::train, Part::val, Part::test, Part::all})
    if (word == to_string(part)) return part;
  throw std::runtime_error("part: '" + word + "' is none of train, val, test, all");
}

}  // namespace cps
