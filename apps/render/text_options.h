#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "distortion/image_size.h"

/// Values of options that are more than a number. Each throws boost::program_options::error naming the option
/// and what it must be.
namespace cps {

/// "A,B,…": exactly `count` finite numbers. `form` says so to people.
std::vector<double> parse_numbers(const std::string& option, const std::string& text, std::size_t count,
                                  const std::string& form);

/// "X,Y,Z" in metres.
Eigen::Vector3d parse_point(const std::string& option, const std::string& text);

/// "WxH", 1 … 32768 pixels each.
ImageSize parse_size(const std::string& text);

}  // namespace cps
