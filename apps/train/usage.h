#pragma once

#include <boost/program_options/errors.hpp>
#include <stdexcept>

namespace cps {

/// Returns parse(), and turns its std::runtime_error (an unknown word) into wrong usage, exit status 2.
template <typename Parse>
decltype(auto) usage_checked(Parse parse) {
  try {
    return parse();
  } catch (const std::runtime_error& error) {
    throw boost::program_options::error(error.what());
  }
}

}  // namespace cps
