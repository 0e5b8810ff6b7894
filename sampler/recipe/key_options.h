#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

#include "sampler/recipe/recipe_values.h"

/// Lists of keys (recipe_keys.h, lens_keys.h) as program options.
namespace cps {

/// What stands for a value of this type in help texts.
template <typename T>
constexpr const char* value_placeholder(const T&) {
  if constexpr (std::is_same_v<T, bool>) return "BOOL";
  if constexpr (std::is_arithmetic_v<T>) return "NUMBER";
  if constexpr (std::is_same_v<T, PerSize>) return "NUMBERS";
  return "TEXT";
}
template <typename T>
constexpr const char* value_placeholder(const std::vector<T>&) {
  return "LIST";
}

/// Every key as a string-valued option; its help text ends with the default in brackets, if it has one.
/// `for_each_key(visit)` visits the defaults.
template <typename ForEachKey>
boost::program_options::options_description key_options(const std::string& title, ForEachKey&& for_each_key) {
  namespace po = boost::program_options;
  po::options_description options(title);
  for_each_key([&](const char* key, const auto& value, const char* help) {
    const std::string text = value_text(value);
    const std::string shown = text.empty() ? "" : " [" + text + "]";
    options.add_options()(key, po::value<std::string>()->value_name(value_placeholder(value)),
                          (help + shown).c_str());
  });
  return options;
}

/// Sets the members whose keys are in `values`. Throws std::runtime_error: key, value, fix.
template <typename ForEachKey>
void read_keys(const boost::program_options::variables_map& values, ForEachKey&& for_each_key) {
  for_each_key([&](const char* key, auto& member, const char*) {
    if (values.count(key) == 0) return;
    const auto& text = values[key].as<std::string>();
    try {
      parse_value(text, member);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(std::string(key) + " = " + text + ": " + error.what());
    }
  });
}

}  // namespace cps
