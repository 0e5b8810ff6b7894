#pragma once

#include <cstdint>
#include <string>

#include "dataset/export/export.h"

struct Stopped {};

/// Stops an export after some images, as a killed process does between two files.
inline cps::ExportProgress stop_after(std::size_t calls) {
  return [calls](std::int64_t, const std::string&) mutable {
    if (--calls == 0) throw Stopped{};
  };
}
