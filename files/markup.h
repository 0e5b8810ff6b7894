#pragma once

#include <string>
#include <string_view>

namespace cps {

/// `text` with &, < and > replaced by their entities, for the text between tags of HTML and XML.
std::string escaped(std::string_view text);

}  // namespace cps
