#pragma once

#include <filesystem>
#include <string>

#include "dataset/report/report_options.h"
#include "dataset/report/survey.h"

/// The sections of a report as HTML. All text from the dataset is escaped, and lists are cut at a bound.
namespace cps {

/// How many images, groups, places … there are, by part and by set; which programs made them.
std::string summary_section(const DatasetSurvey& survey);

/// Thumbnails of each set with the numbers of their lenses. Throws std::runtime_error naming an image that
/// cannot be read.
std::string sheets_section(const DatasetSurvey& survey, const ReportOptions& options);

/// A list of lenses, one of which is drawn: a straight grid as its image shows it.
std::string lens_section(const DatasetSurvey& survey, const ReportOptions& options);

/// Distributions of all labels beside their limits.
std::string label_section(const DatasetSurvey& survey);

/// Maps of the places, and how many were rejected.
std::string place_section(const DatasetSurvey& survey);

/// The conditions: sun, sky and weather.
std::string light_section(const DatasetSurvey& survey);

/// Scenes with their import warnings, the rig, the recipe.
std::string origin_section(const DatasetSurvey& survey);

/// What cps verify found. Throws std::runtime_error with one line if its files are damaged.
std::string check_section(const std::filesystem::path& root);

/// What runs of cps generate took, and what their journals hold. Throws std::runtime_error with one line if
/// the ledger is damaged.
std::string cost_section(const std::filesystem::path& root);

}  // namespace cps
