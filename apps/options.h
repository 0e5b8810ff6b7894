#pragma once

#include <boost/program_options.hpp>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "sampler/recipe/key_options.h"

namespace cps {

/// Parses a verb's arguments. With --help, prints `usage` and the options and returns false. Unknown flags
/// and missing values throw boost::program_options::error.
inline bool parse_options(const std::vector<std::string>& arguments, const std::string& usage,
                          boost::program_options::options_description visible,
                          const boost::program_options::positional_options_description& positional,
                          boost::program_options::variables_map& values) {
  namespace po = boost::program_options;
  visible.add_options()("help,h", "this text");
  // Options may not be shortened: a recipe key added later must not change what a script means.
  const int style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
  po::store(po::command_line_parser(arguments).options(visible).positional(positional).style(style).run(),
            values);
  if (values.count("help") == 0) return true;
  std::cout << usage << "\n" << visible;
  return false;
}

/// The text of a flag as a number, a size, or a list of them. Throws boost::program_options::error naming the
/// flag.
template <typename T>
T flag_value(const std::string& flag, const std::string& text) {
  T value{};
  try {
    parse_value(text, value);
  } catch (const std::runtime_error& error) {
    throw boost::program_options::error("--" + flag + " " + text + ": " + error.what());
  }
  return value;
}

/// read_keys() for flags: what cannot be read is wrong usage.
template <typename ForEachKey>
void read_key_flags(const boost::program_options::variables_map& values, ForEachKey&& for_each_key) {
  try {
    read_keys(values, for_each_key);
  } catch (const std::runtime_error& error) {
    throw boost::program_options::error(error.what());
  }
}

}  // namespace cps
