#include "sampler/recipe/rig_file.h"

#include <boost/program_options/parsers.hpp>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

#include "sampler/recipe/recipe_values.h"

namespace po = boost::program_options;

namespace cps {
namespace {

/// Calls visit(key, member, is_required) for each key of a camera's section.
template <typename Camera, typename Visitor>
void for_each_camera_key(Camera& camera, Visitor&& visit) {
  visit("forward_m", camera.position_m.x(), true);
  visit("left_m", camera.position_m.y(), true);
  visit("up_m", camera.position_m.z(), true);
  visit("yaw_deg", camera.yaw_deg, false);
  visit("pitch_deg", camera.pitch_deg, false);
  visit("roll_deg", camera.roll_deg, false);
}

void set_key(RigCamera& camera, const std::string& key, const std::string& text) {
  bool is_known = false;
  std::string known;
  for_each_camera_key(camera, [&](const char* name, double& member, bool) {
    known += known.empty() ? name : std::string(", ") + name;
    if (key != name) return;
    is_known = true;
    parse_value(text, member);
  });
  if (!is_known) throw std::runtime_error("is none of " + known);
}

void require_keys(RigCamera& camera, const std::set<std::string>& given) {
  for_each_camera_key(camera, [&](const char* name, double&, bool is_required) {
    if (is_required && !given.contains(camera.name + "." + name))
      throw std::runtime_error(camera.name + "." + name + ": is missing");
  });
}

Rig rig_from(const std::vector<po::option>& lines) {
  Rig rig{.cameras = {}};
  std::set<std::string> given;
  for (const po::option& line : lines) {
    const std::size_t dot = line.string_key.rfind('.');
    if (dot == std::string::npos) throw std::runtime_error(line.string_key + ": belongs under a [camera]");
    const std::string name = line.string_key.substr(0, dot), key = line.string_key.substr(dot + 1);
    if (rig.cameras.empty() || rig.cameras.back().name != name) rig.cameras.push_back({.name = name});
    if (!given.insert(line.string_key).second) throw std::runtime_error(line.string_key + ": is given twice");
    try {
      set_key(rig.cameras.back(), key, line.value.at(0));
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(line.string_key + ": " + error.what());
    }
  }
  for (RigCamera& camera : rig.cameras) require_keys(camera, given);
  if (const std::string fault = rig.fault(); !fault.empty()) throw std::runtime_error(fault);
  return rig;
}

}  // namespace

Rig read_rig(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream || std::filesystem::is_directory(file))
    throw std::runtime_error(file.string() + ": cannot be read; name a rig file");
  try {
    return rig_from_text({std::istreambuf_iterator<char>(stream), {}});
  } catch (const std::exception& error) {
    throw std::runtime_error(file.string() + ": " + error.what());
  }
}

Rig rig_from_text(const std::string& text) {
  std::istringstream lines(text);
  const po::options_description none;
  return rig_from(po::parse_config_file(lines, none, true).options);
}

Rig find_rig(const std::string& named, const std::filesystem::path& recipe_folder) {
  if (named.empty()) return {};
  if (std::filesystem::exists(named)) return read_rig(named);
  const std::filesystem::path beside = recipe_folder / named;
  if (std::filesystem::exists(beside)) return read_rig(beside);
  throw std::runtime_error("rig = " + named +
                           ": there is no such file, neither at that path nor beside the recipe");
}

std::string to_text(const Rig& rig) {
  std::string text;
  for (const RigCamera& camera : rig.cameras) {
    text += "[" + camera.name + "]\n";
    for_each_camera_key(camera, [&](const char* key, const double& value, bool) {
      text += std::string(key) + " = " + value_text(value) + "\n";
    });
  }
  return text;
}

}  // namespace cps
