#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "dataset/export/source.h"

/// The label of one image as one flat object: of a WebDataset sample, and of a line of metadata.jsonl.
namespace cps {

enum class ColumnType { text, integer, number };

struct SampleColumn {
  const char* name;
  ColumnType type;
  const char* meaning;  ///< a phrase, with the unit
  bool needs_frame;     ///< comes from frames.csv, which a set of cps relens lacks
  nlohmann::ordered_json (*value)(const ExportSource& source, const DatasetImage& image);
};

/// The columns that this dataset's images have, in the order in which they are written: the same for all.
std::vector<SampleColumn> sample_columns(const ExportSource& source);

/// One object with a key for each of those columns.
nlohmann::ordered_json sample_json(const ExportSource& source, const DatasetImage& image);

/// The same with `file_name` before all others, on one line that ends.
std::string metadata_line(const ExportSource& source, const DatasetImage& image);

}  // namespace cps
