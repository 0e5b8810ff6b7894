#pragma once

#include <cstdint>
#include <string>

namespace cps {

/// `1,495,000`
std::string grouped(std::int64_t number);

/// `4.2 GB`, in powers of 1000.
std::string bytes_text(double bytes);

/// `12.5 %` of a whole, with a space that does not break; `–` of nothing.
std::string percent(std::int64_t part, std::int64_t whole);

/// The text as markup, at most `max_bytes` of it and then an ellipsis.
std::string clipped(const std::string& text, std::size_t max_bytes);

}  // namespace cps
