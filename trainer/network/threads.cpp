#include "trainer/network/threads.h"

#include <ATen/Parallel.h>
#include <tbb/info.h>

namespace cps {

void use_threads(int threads) {
  at::set_num_threads(threads > 0 ? threads : tbb::info::default_concurrency());
}

}  // namespace cps
