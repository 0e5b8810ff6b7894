#include "apps/manual/option_groups.h"

#include <fmt/format.h>

#include <boost/program_options/value_semantic.hpp>
#include <charconv>
#include <sstream>
#include <typeinfo>
#include <vector>

namespace po = boost::program_options;

namespace cps {
namespace {

/// BOOL, NUMBER or TEXT, by the type of the option's value.
std::string usual_placeholder(const po::value_semantic& value) {
  const auto* typed = dynamic_cast<const po::typed_value_base*>(&value);
  if (typed == nullptr) return "TEXT";
  const std::type_info& type = typed->value_type();
  if (type == typeid(bool)) return "BOOL";
  for (const std::type_info* number : {&typeid(int), &typeid(unsigned), &typeid(long), &typeid(unsigned long),
                                       &typeid(float), &typeid(double), &typeid(std::vector<double>)})
    if (type == *number) return "NUMBER";
  return "TEXT";
}

/// A default as a person would write it: Boost prints 0.1 as 0.10000000000000001.
std::string plain_default(const std::string& text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && rest == end && text.size() > 12 ? fmt::format("{}", value) : text;
}

OptionEntry entry_of(const po::option_description& option) {
  OptionEntry entry{.name = option.long_name(), .help = option.description()};
  const std::string spelled = option.format_name();  // "-o [ --out ]" or "--out"
  if (spelled.size() > 1 && spelled[1] != '-') entry.letter = spelled[1];
  const po::value_semantic& value = *option.semantic();
  if (value.max_tokens() == 0) return entry;
  const std::string shown = value.name();  // "arg", "FILE", "arg (=0.5)"
  const std::size_t end = shown.find(" (=");
  entry.placeholder = shown.substr(0, end);
  if (entry.placeholder == po::arg) entry.placeholder = usual_placeholder(value);
  if (end != shown.npos) entry.default_text = plain_default(shown.substr(end + 3, shown.size() - end - 4));
  return entry;
}

}  // namespace

std::vector<OptionGroup> option_groups(const po::options_description& options) {
  // Boost keeps the groups to itself, so they are read from what it prints: a title a line, then the options.
  // Further lines of an option's help are indented more.
  std::ostringstream printed;
  printed << options;
  std::istringstream lines(printed.str());
  std::vector<OptionGroup> groups(1);
  for (std::string line; std::getline(lines, line);) {
    if (!line.empty() && line.front() != ' ' && line.back() == ':')
      groups.push_back({line.substr(0, line.size() - 1), {}});
    if (!line.starts_with("  -")) continue;
    const std::size_t name = line.find("--") + 2;
    groups.back().options.push_back(
        entry_of(options.find(line.substr(name, line.find(' ', name) - name), false)));
  }
  std::erase_if(groups, [](const OptionGroup& group) { return group.options.empty(); });
  return groups;
}

}  // namespace cps
