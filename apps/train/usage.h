#pragma once

#include <boost/program_options/errors.hpp>
#include <stdexcept>

namespace cps {

/// The value of `parse`, whose std::runtime_error (a word that names no such thing) becomes wrong usage,
/// exit 2.
template <typename Parse>
decltype(auto) usage_checked(Parse parse) {
  try {
    return parse();
  } catch (const std::runtime_error& error) {
    throw boost::program_options::error(error.what());
  }
}

}  // namespace cps
