#pragma once

#include <string>
#include <string_view>

namespace cps {

/// `text` with &, <, > and " replaced by their entities: for HTML and XML, between tags and in attributes in
/// double quotes.
std::string escaped(std::string_view text);

}  // namespace cps
