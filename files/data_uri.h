#pragma once

#include <span>
#include <string>

namespace cps {

/// A file inside an HTML page: `data:<media_type>;base64,…`.
std::string data_uri(const std::string& media_type, std::span<const char> bytes);

}  // namespace cps
