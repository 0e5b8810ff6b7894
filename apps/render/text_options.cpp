#include "apps/render/text_options.h"

#include <algorithm>
#include <cmath>

#include "apps/options.h"

namespace po = boost::program_options;

namespace cps {

std::vector<double> parse_numbers(const std::string& option, const std::string& text, std::size_t count,
                                  const std::string& form) {
  const auto numbers = flag_value<std::vector<double>>(option, text);
  const bool finite = std::all_of(numbers.begin(), numbers.end(), [](double n) { return std::isfinite(n); });
  if (numbers.size() != count || !finite) throw po::error("--" + option + " " + text + ": must be " + form);
  return numbers;
}

Eigen::Vector3d parse_point(const std::string& option, const std::string& text) {
  return Eigen::Map<const Eigen::Vector3d>(parse_numbers(option, text, 3, "X,Y,Z in metres").data());
}

ImageSize parse_size(const std::string& text) {
  const auto size = flag_value<ImageSize>("size", text);
  if (std::min(size.width, size.height) < 1 || std::max(size.width, size.height) > 32768)
    throw po::error("--size " + text + ": must be WIDTHxHEIGHT in pixels, at most 32768 each");
  return size;
}

}  // namespace cps
