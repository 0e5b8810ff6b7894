#include <fmt/format.h>

#include "dataset/dense/dense_file.h"
#include "dataset/export/huggingface.h"
#include "dataset/export/sample_columns.h"

namespace cps {
namespace {

/// A JSON string, which is one of YAML, too.
std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump();
}

const char* yaml_type(ColumnType type) {
  switch (type) {
    case ColumnType::text:
      return "string";
    case ColumnType::integer:
      return "int64";
    case ColumnType::number:
      break;
  }
  return "float64";
}

/// Hugging Face's word for the number of images.
std::string size_category(std::int64_t images) {
  if (images < 1'000) return "n<1K";
  if (images < 10'000) return "1K<n<10K";
  if (images < 100'000) return "10K<n<100K";
  if (images < 1'000'000) return "100K<n<1M";
  return "1M<n<10M";
}

std::string header(const ExportJob& job, const std::vector<HuggingFaceSplit>& splits) {
  std::string yaml = "---\npretty_name: " + quoted(job.source.name) + "\n";
  if (!job.options.license.empty()) yaml += "license: " + quoted(job.options.license) + "\n";
  yaml += "tags:\n- camera-calibration\n- lens-distortion\n- synthetic\n";
  yaml += "size_categories:\n- " +
          quoted(size_category(static_cast<std::int64_t>(job.source.dataset().images.size()))) + "\n";
  yaml += "configs:\n- config_name: default\n  data_files:\n";
  for (const HuggingFaceSplit& split : splits)
    yaml += fmt::format("  - split: {0}\n    path: \"{0}/**\"\n", split.part);
  yaml += "dataset_info:\n  features:\n  - name: image\n    dtype: image\n";
  for (const SampleColumn& column : sample_columns(job.source))
    yaml += fmt::format("  - name: {}\n    dtype: {}\n", column.name, yaml_type(column.type));
  yaml += "  splits:\n";
  for (const HuggingFaceSplit& split : splits)
    yaml += fmt::format("  - name: {}\n    num_examples: {}\n", split.part, split.metadata.samples);
  return yaml + "---\n";
}

std::string columns_table(const ExportSource& source) {
  std::string table =
      "| column | type | meaning |\n|---|---|---|\n| `image` | image | the image as stored |\n";
  for (const SampleColumn& column : sample_columns(source))
    table += fmt::format("| `{}` | {} | {} |\n", column.name, yaml_type(column.type), column.meaning);
  return table;
}

std::string dense_section(const ExportSource& source) {
  if (source.dense_labels.empty()) return "";
  std::string section =
      "\n## Dense labels\n\nEvery pixel is labelled with what its central ray meets, through the image's "
      "lens. The files lie under `dense/`, in\nthe folders of their images and with their names.\n\n"
      "| label | file of the image `train/000017.png` | holds |\n|---|---|---|\n";
  for (DenseLabel label : source.dense_labels)
    section += fmt::format("| {} | `{}` | {} |\n", to_string(label),
                           dense_file("dense/train/000017.png", label).string(), dense_meaning(label));
  if (source.has(DenseLabel::semantic))
    section +=
        "\n`dense/classes.json` names the scene of each `condition`, and what the values of `semantic` mean in "
        "each scene.\n";
  return section;
}

std::string credits_section(const ExportSource& source) {
  if (source.credits.empty()) return "";
  std::string section = "\n## Credits of the scenes\n\n```\n";
  return section + source.credits + "```\n";
}

}  // namespace

const char* dense_meaning(DenseLabel label) {
  switch (label) {
    case DenseLabel::depth:
      return "metres along the optical axis; infinite where nothing is";
    case DenseLabel::distance:
      return "metres along the ray; infinite where nothing is";
    case DenseLabel::normal:
      return "unit vector X, Y, Z of the surface, camera axes (x right, y down, z forward); 0 where nothing is";
    case DenseLabel::instance:
      return "0 where nothing is, otherwise 1 + the number of the object in its scene";
    case DenseLabel::semantic:
      return "class";
    case DenseLabel::rays:
      return "unit vector X, Y, Z of the ray, camera axes (x right, y down, z forward)";
    case DenseLabel::up:
      return "unit vector X, Y in the image (x right, y down) that leads upwards in the world; 0 for a vertical ray";
    case DenseLabel::latitude:
      break;
  }
  return "degrees of the ray above the horizon";
}

std::string dataset_description(const ExportSource& source) {
  std::string generator = source.label_of(source.dataset().images.front()).generator;
  return fmt::format(
      "{} images with exact camera calibrations, made by {}. Each shows its scene through a lens of the "
      "Brown-Conrady model that is proved one-to-one on the image.",
      source.dataset().images.size(), generator);
}

std::string dataset_card(const ExportJob& job, const std::vector<HuggingFaceSplit>& splits) {
  std::string card = header(job, splits) + "\n# " + job.source.name + "\n\n" +
                     dataset_description(job.source) + "\n\n| split | images |\n|---|---|\n";
  for (const HuggingFaceSplit& split : splits)
    card += fmt::format("| {} | {} |\n", split.part, split.metadata.samples);
  card += "\nA street and a lens belong to one split only; images without distortion occur in all of them.\n";
  card += "\n## Columns\n\n" + columns_table(job.source);
  card += R"(
A point (X, Y, Z) in camera axes (x right, y down, z forward) has x = X/Z, y = Y/Z, r^2 = x^2 + y^2 and is seen at the pixel
(fx x_d + cx, fy y_d + cy), with

    x_d = x (1 + k1 r^2 + k2 r^4 + k3 r^6) + 2 p1 x y + p2 (r^2 + 2 x^2)
    y_d = y (1 + k1 r^2 + k2 r^4 + k3 r^6) + p1 (r^2 + 2 y^2) + 2 p2 x y

## Loading

```python
from datasets import load_dataset
data = load_dataset("PATH OF THIS FOLDER")
print(data["train"][0])
```
)";
  return card + dense_section(job.source) + credits_section(job.source);
}

}  // namespace cps
