#pragma once

#include <cstddef>
#include <functional>

namespace cps {

/// Calls work(i) for i = 0 … count − 1: several at a time, each on one thread that takes no other work
/// meanwhile, so that its clock counts this call alone. Throws the first error, in the order of i, once all
/// calls have ended: an exception that left the loop would cancel the loops inside other calls, whose images
/// would then be written with pixels missing.
void for_each_image(std::size_t count, const std::function<void(std::size_t)>& work);

}  // namespace cps
