#pragma once

#include <string>
#include <vector>

#include "dataset/export/targets.h"

namespace cps {

/// The part of a dataset in one folder `<part>/` of the export, with its metadata.jsonl.
struct HuggingFaceSplit {
  std::string part;
  ExportedFile metadata;
  std::string image_ending;  ///< .png, .jpg or .exr
};

/// README.md: a YAML header that tells Hugging Face where the splits are and what their columns hold, and the
/// same for people.
std::string dataset_card(const ExportJob& job, const std::vector<HuggingFaceSplit>& splits);

/// croissant.json: the splits, their files and columns in MLCommons' vocabulary, Croissant 1.1.
nlohmann::ordered_json croissant(const ExportJob& job, const std::vector<HuggingFaceSplit>& splits);

/// The properties that Croissant 1.1 requires and the options leave out, separated by commas.
std::string missing_in_croissant(const ExportOptions& options);

/// What the files of a dense label hold: channels and units.
const char* dense_meaning(DenseLabel label);

/// What the dataset is, in two sentences.
std::string dataset_description(const ExportSource& source);

}  // namespace cps
