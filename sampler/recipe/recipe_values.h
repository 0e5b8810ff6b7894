#pragma once

#include <charconv>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "sampler/recipe/recipe.h"

/// Recipe values as text and back. Numbers are written with as few digits as read back to the same bits.
namespace cps {

inline void parse_value(std::string_view text, std::string& value) {
  value = text;
}

template <typename Number>
requires std::is_arithmetic_v<Number>
void parse_value(std::string_view text, Number& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw std::runtime_error(std::is_integral_v<Number> ? "is not a whole number in range"
                                                        : "is not a number");
}

inline void parse_value(std::string_view text, bool& value) {
  if (text != "true" && text != "false") throw std::runtime_error("is neither true nor false");
  value = text == "true";
}

inline void parse_value(std::string_view text, ImageSize& value) {
  const std::size_t x = text.find('x');
  if (x == text.npos) throw std::runtime_error("is not a size; write it as 1392x512");
  parse_value(text.substr(0, x), value.width);
  parse_value(text.substr(x + 1), value.height);
}

inline void parse_value(std::string_view text, LensScheme& value) {
  value = lens_scheme_from_string(std::string(text));
}

inline void parse_value(std::string_view text, ImageFormat& value) {
  value = image_format_from(std::string(text));
}

inline void parse_value(std::string_view text, LightMethod& value) {
  value = light_method_from(std::string(text));
}

inline void parse_value(std::string_view text, DenseLabel& value) {
  value = dense_label_from(std::string(text));
}

inline void parse_value(std::string_view text, CityStyle& value) {
  value = city_style_from(std::string(text));
}

template <typename T>
void parse_value(std::string_view text, std::vector<T>& values) {
  constexpr const char* separators = std::is_same_v<T, std::string> ? "," : ", ";  // file names have spaces
  values.clear();
  while (!text.empty()) {
    const std::size_t begin = text.find_first_not_of(", ");
    if (begin == text.npos) break;
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    const std::string_view item = text.substr(begin, end - begin);
    parse_value(item.substr(0, item.find_last_not_of(' ') + 1), values.emplace_back());
    text.remove_prefix(end);
  }
}

inline void parse_value(std::string_view text, PerSize& value) {
  parse_value(text, value.values);
}

inline void parse_value(std::string_view text, Coefficient& value) {
  value = coefficient_from_string(std::string(text));
}

inline std::string value_text(const std::string& value) {
  return value;
}

template <typename Number>
requires std::is_arithmetic_v<Number> std::string value_text(Number value) {
  char digits[64];
  return std::string(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

inline std::string value_text(bool value) {
  return value ? "true" : "false";
}

inline std::string value_text(const ImageSize& size) {
  return value_text(size.width) + "x" + value_text(size.height);
}

inline std::string value_text(LensScheme scheme) {
  return to_string(scheme);
}

inline std::string value_text(ImageFormat format) {
  return to_string(format);
}

inline std::string value_text(LightMethod method) {
  return to_string(method);
}

inline std::string value_text(DenseLabel label) {
  return to_string(label);
}

inline std::string value_text(CityStyle style) {
  return to_string(style);
}

inline std::string value_text(Coefficient value) {
  return to_string(value);
}

template <typename T>
std::string value_text(const std::vector<T>& values) {
  std::string text;
  for (const T& value : values) text += (text.empty() ? "" : ", ") + value_text(value);
  return text;
}

inline std::string value_text(const PerSize& value) {
  return value_text(value.values);
}

}  // namespace cps
