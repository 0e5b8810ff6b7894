#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

namespace cps {

/// Called after each leaf folder, with its name; may throw to stop.
using MigrationProgress = std::function<void(const std::string& folder)>;

/// Rewrites what a finished dataset, or a set of cps relens, says in the form of an older schema in today's
/// (label_schema): every calibration.json and frames.csv, and last dataset.json. New keys and columns are
/// added, all others keep their values and order; images, lists and journals are not touched. Every file is
/// replaced by rename and can be read in either form, so a migration that was stopped leaves a dataset that
/// is whole, and goes on when it is called again. Returns the number of files that were rewritten. Throws
/// HeldByAnother while other processes work in the folder, and std::runtime_error with one line when it is no
/// finished dataset, or a file cannot be read or written.
std::int64_t migrate_dataset(const std::filesystem::path& root, const MigrationProgress& progress);

}  // namespace cps
