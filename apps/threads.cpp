#include "apps/threads.h"

#include <fmt/format.h>
#include <tbb/info.h>

#include <boost/program_options/errors.hpp>
#include <boost/program_options/value_semantic.hpp>

namespace po = boost::program_options;

namespace cps {
namespace {

constexpr int max_threads = 4096;

int thread_count(int asked) {
  if (asked < 0 || asked > max_threads)
    throw po::error(
        fmt::format("--threads {}: must lie in [0, {}]; 0 means one per core", asked, max_threads));
  return asked > 0 ? asked : tbb::info::default_concurrency();
}

}  // namespace

void add_threads_option(po::options_description& options) {
  options.add_options()("threads", po::value<int>()->default_value(0),
                        "number of threads; 0 means one per core");
}

ThreadLimit::ThreadLimit(const po::variables_map& values)
    : count(thread_count(values["threads"].as<int>())),
      control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count)) {}

}  // namespace cps
