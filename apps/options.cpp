#include "apps/options.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <string_view>
#include <utility>

#include "apps/manual/help_text.h"
#include "apps/manual/pages.h"

namespace po = boost::program_options;

namespace cps {
namespace {

/// Two names of one thing: a verb that has an option of the one name accepts the other as well.
constexpr std::array<std::pair<std::string_view, std::string_view>, 5> synonyms{{
    {"out", "output"},
    {"lens-camera", "camera"},
    {"lens_draw", "draw"},
    {"data", "dataset"},
    {"max_shaded_vertices", "bounces"},
}};

bool is_same_name(std::string_view a, std::string_view b) {
  const auto plain = [](char c) { return c == '-' ? '_' : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return plain(x) == plain(y); });
}

/// The option's name as the verb spells it; empty if the verb has no such option.
std::string known_name(std::string_view name, const po::options_description& options) {
  for (const auto& option : options.options())
    if (is_same_name(option->long_name(), name)) return option->long_name();
  return "";
}

std::string spelled_name(std::string_view name, const po::options_description& options) {
  std::string known = known_name(name, options);
  for (const auto& [one, other] : synonyms) {
    if (known.empty() && is_same_name(name, one)) known = known_name(other, options);
    if (known.empty() && is_same_name(name, other)) known = known_name(one, options);
  }
  return known.empty() ? std::string(name) : known;
}

/// The arguments with option names as the verb spells them. Values stay as they are.
std::vector<std::string> spelled_arguments(std::vector<std::string> arguments,
                                           const po::options_description& options) {
  for (std::string& argument : arguments) {
    if (argument == "--") break;  // what follows are values
    if (!argument.starts_with("--")) continue;
    const std::size_t end = std::min(argument.find('='), argument.size());
    argument =
        "--" + spelled_name(std::string_view(argument).substr(2, end - 2), options) + argument.substr(end);
  }
  return arguments;
}

}  // namespace

bool parse_options(const std::vector<std::string>& arguments, const Manual& manual,
                   po::options_description visible, const po::positional_options_description& positional,
                   po::variables_map& values) {
  visible.add_options()("help,h", "print this text");
  if (print_page(arguments, manual, visible)) return false;
  // Options may not be shortened: a recipe key added later must not change what a script means.
  const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::store(po::command_line_parser(spelled_arguments(arguments, visible))
                .options(visible)
                .positional(positional)
                .style(style)
                .run(),
            values);
  if (values.count("help") == 0) return true;
  std::cout << help_text(manual, option_groups(visible));
  return false;
}

po::typed_value<std::string>* path_value(std::filesystem::path& target) {
  return po::value<std::string>()->value_name("FILE")->notifier(
      [&target](const std::string& text) { target = text; });
}

ImageSize picture_size(const std::string& flag, const std::string& text) {
  const auto size = flag_value<ImageSize>(flag, text);
  constexpr std::int64_t max_pixels = 1 << 28;
  if (size.width < 1 || size.height < 1 || std::int64_t{size.width} * size.height > max_pixels)
    throw po::error("--" + flag + " " + text + ": must be 1x1 to 268 million pixels");
  return size;
}

}  // namespace cps
