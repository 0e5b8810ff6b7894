#pragma once

#include <filesystem>
#include <string>

#include "dataset/report/report_options.h"

namespace cps {

/// One HTML page about a finished dataset, below 10 MB whatever the dataset's size, that needs no other file
/// and no network. The same folder gives the same page. Throws std::runtime_error with one line: folder or
/// file, what is wrong, what to do.
std::string report_page(const std::filesystem::path& root, const ReportOptions& options = {});

}  // namespace cps
