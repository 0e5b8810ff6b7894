#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "distortion/image_size.h"

/// Parses values of options that are more than a number. Each function throws boost::program_options::error
/// that names the option and the expected form.
namespace cps {

/// "A,B,…": exactly `count` finite numbers. `form` describes them in the error message.
std::vector<double> parse_numbers(const std::string& option, const std::string& text, std::size_t count,
                                  const std::string& form);

/// "X,Y,Z" in metres.
Eigen::Vector3d parse_point(const std::string& option, const std::string& text);

/// "WxH", 1 … 32768 pixels each.
ImageSize parse_size(const std::string& text);

}  // namespace cps
