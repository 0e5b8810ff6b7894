#include "apps/manual/manual.h"

#include <algorithm>

namespace cps {

std::string page_name(const std::string& manual_name) {
  std::string name = manual_name;
  std::replace(name.begin(), name.end(), ' ', '-');
  return name;
}

}  // namespace cps
