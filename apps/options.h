#pragma once

#include <boost/program_options.hpp>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "apps/manual/manual.h"
#include "sampler/recipe/key_options.h"

namespace cps {

/// Parses a verb's arguments. With --help, prints `manual` and the options and returns false; so it does for
/// the verb's man page and completion (apps/manual/pages.h). Unknown options and missing values throw
/// boost::program_options::error.
///
/// Option names may be written with `-` or `_` (--max-zoom is --max_zoom), and a few have a second name that
/// every verb accepts, such as --output for --out.
bool parse_options(const std::vector<std::string>& arguments, const Manual& manual,
                   boost::program_options::options_description visible,
                   const boost::program_options::positional_options_description& positional,
                   boost::program_options::variables_map& values);

/// A file or folder, read as a whole, spaces included; Boost cuts a std::filesystem::path at the first space.
boost::program_options::typed_value<std::string>* path_value(std::filesystem::path& target);

/// The text of an option as a number, a size, or a list of them. Throws boost::program_options::error naming
/// the option.
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

/// WIDTHxHEIGHT of a picture. Throws boost::program_options::error naming the option, too for sizes that no
/// memory holds.
ImageSize picture_size(const std::string& flag, const std::string& text);

/// read_keys() for options of the command line: a value that cannot be read is wrong usage.
template <typename ForEachKey>
void read_key_flags(const boost::program_options::variables_map& values, ForEachKey&& for_each_key) {
  try {
    read_keys(values, for_each_key);
  } catch (const std::runtime_error& error) {
    throw boost::program_options::error(std::string("--") + error.what());
  }
}

/// Throws boost::program_options::error naming the option, unless `fault`, "key: what is wrong", is empty.
inline void refuse_flags_with(const std::string& fault) {
  if (!fault.empty()) throw boost::program_options::error("--" + fault);
}

}  // namespace cps
