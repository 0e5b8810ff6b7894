#include "trainer/training/slurm_step.h"

#include <netdb.h>

#include <charconv>
#include <cstdint>
#include <cstdlib>

namespace cps {
namespace {

std::string_view variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// The number that the text begins with; 0 if there is none.
std::uint64_t number(std::string_view text) {
  std::uint64_t value = 0;
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

bool can_be_resolved(const std::string& host) {
  addrinfo* found = nullptr;
  const bool is_known = getaddrinfo(host.c_str(), nullptr, nullptr, &found) == 0;
  if (is_known) freeaddrinfo(found);
  return is_known;
}

}  // namespace

std::string first_node(std::string_view list) {
  std::string name;
  bool is_skipping = false;  // the rest of a bracket
  bool is_inside = false;
  for (const char c : list) {
    if (c == '[') {
      is_inside = true;
    } else if (c == ']') {
      is_inside = is_skipping = false;
    } else if (is_inside && (c == ',' || c == '-')) {
      is_skipping = true;
    } else if (c == ',') {
      break;
    } else if (!is_skipping) {
      name += c;
    }
  }
  return name;
}

MeetingPoint slurm_meeting_point() {
  MeetingPoint point;
  point.port =
      20000 +
      static_cast<int>((31 * number(variable("SLURM_JOB_ID")) + number(variable("SLURM_STEP_ID"))) % 10000);
  point.host =
      variable("SLURM_STEP_NUM_NODES") == "1" ? "127.0.0.1" : first_node(variable("SLURM_STEP_NODELIST"));
  if (!point.host.empty() && !can_be_resolved(point.host)) {
    const std::string_view launcher = variable("SLURM_LAUNCH_NODE_IPADDR");
    if (!launcher.empty()) point.host = launcher;
  }
  return point;
}

}  // namespace cps
