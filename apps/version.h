#pragma once

namespace cps {

/// The git commit that the program was built from, shortened, with "-dirty" if files differed from it;
/// "unknown" if the sources are not a checkout. The build writes the file that defines it
/// (cmake/version.cmake).
extern const char* const source_commit;

}  // namespace cps
