#pragma once

#include <tbb/global_control.h>

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/variables_map.hpp>

/// `--threads`, the same in every verb.
namespace cps {

/// Adds `--threads N` to a verb's options.
void add_threads_option(boost::program_options::options_description& options);

/// Lets at most `count` threads work at a time, as long as it lives.
struct ThreadLimit {
  int count;  ///< 1 or more
  tbb::global_control control;

  /// As many as `--threads` says, or one per core. Throws boost::program_options::error on a number out of
  /// range.
  explicit ThreadLimit(const boost::program_options::variables_map& values);
};

}  // namespace cps
