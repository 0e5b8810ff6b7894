#include "dataset/dense/dense_file.h"
#include "dataset/export/huggingface.h"
#include "dataset/export/sample_columns.h"

/// Croissant 1.1, http://mlcommons.org/croissant/1.1: JSON-LD whose context stands in the file, so that a
/// reader needs no network.
namespace cps {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

Json context() {
  Json json = {{"@language", "en"},
               {"@vocab", "http://schema.org/"},
               {"sc", "http://schema.org/"},
               {"cr", "http://mlcommons.org/croissant/"},
               {"dct", "http://purl.org/dc/terms/"},
               {"conformsTo", "dct:conformsTo"},
               {"dataType", {{"@id", "cr:dataType"}, {"@type", "@vocab"}}}};
  for (const char* term : {"column", "extract", "field", "fileObject", "fileProperty", "fileSet", "includes",
                           "key", "recordSet", "references", "regex", "source", "transform"})
    json[term] = std::string("cr:") + term;
  return json;
}

Json reference(const std::string& id) {
  return {{"@id", id}};
}

const char* croissant_type(ColumnType type) {
  switch (type) {
    case ColumnType::text:
      return "sc:Text";
    case ColumnType::integer:
      return "sc:Integer";
    case ColumnType::number:
      break;
  }
  return "sc:Float";
}

std::string mime_type(const std::string& ending) {
  if (ending == ".jpg") return "image/jpeg";
  return ending == ".exr" ? "image/x-exr" : "image/png";
}

std::string images_id(const HuggingFaceSplit& split) {
  return split.part + "-images";
}

void add_files(Json& distribution, const ExportSource& source, const HuggingFaceSplit& split) {
  distribution.push_back({{"@type", "cr:FileObject"},
                          {"@id", split.metadata.name},
                          {"name", split.metadata.name},
                          {"contentUrl", split.metadata.name},
                          {"contentSize", std::to_string(split.metadata.bytes) + " B"},
                          {"encodingFormat", "application/jsonlines"},
                          {"sha256", split.metadata.sha256}});
  distribution.push_back({{"@type", "cr:FileSet"},
                          {"@id", images_id(split)},
                          {"name", images_id(split)},
                          {"encodingFormat", mime_type(split.image_ending)},
                          {"includes", split.part + "/**/*" + split.image_ending}});
  for (DenseLabel label : source.dense_labels) {
    const std::string id = split.part + "-" + to_string(label), file = dense_file("*", label).string();
    distribution.push_back({{"@type", "cr:FileSet"},
                            {"@id", id},
                            {"name", id},
                            {"description", dense_meaning(label)},
                            {"encodingFormat", mime_type(fs::path(file).extension())},
                            {"includes", "dense/" + split.part + "/**/" + file}});
  }
}

/// A field whose values are a column of the split's metadata.jsonl.
Json column_field(const HuggingFaceSplit& split, const std::string& record_set, const std::string& name,
                  ColumnType type, const std::string& meaning) {
  return {{"@type", "cr:Field"},
          {"@id", record_set + "/" + name},
          {"name", name},
          {"description", meaning},
          {"dataType", croissant_type(type)},
          {"source", {{"fileObject", reference(split.metadata.name)}, {"extract", {{"column", name}}}}}};
}

/// The lines of metadata.jsonl, by the name of the image's file; the images refer to it.
Json labels_set(const HuggingFaceSplit& split) {
  const std::string id = split.part + "-labels";
  return {{"@type", "cr:RecordSet"},
          {"@id", id},
          {"name", id},
          {"key", reference(id + "/file_name")},
          {"field", Json::array({column_field(split, id, "file_name", ColumnType::text,
                                              "the image's file, relative to the split's folder")})}};
}

/// The images of a split with all columns of their lines.
Json images_set(const ExportSource& source, const HuggingFaceSplit& split) {
  const std::string& id = split.part;
  const Json images = reference(images_id(split));
  Json fields = Json::array();
  fields.push_back({{"@type", "cr:Field"},
                    {"@id", id + "/file_name"},
                    {"name", "file_name"},
                    {"description", "the image's file, relative to the split's folder"},
                    {"dataType", "sc:Text"},
                    {"source",
                     {{"fileSet", images},
                      {"extract", {{"fileProperty", "fullpath"}}},
                      {"transform", {{"regex", split.part + "/(.+)$"}}}}},
                    {"references", reference(split.part + "-labels/file_name")}});
  fields.push_back({{"@type", "cr:Field"},
                    {"@id", id + "/image"},
                    {"name", "image"},
                    {"description", "the image as stored"},
                    {"dataType", "sc:ImageObject"},
                    {"source", {{"fileSet", images}, {"extract", {{"fileProperty", "content"}}}}}});
  for (const SampleColumn& column : sample_columns(source))
    fields.push_back(column_field(split, id, column.name, column.type, column.meaning));
  return {{"@type", "cr:RecordSet"},
          {"@id", id},
          {"name", id},
          {"description", "the images of the " + split.part + " split with their labels"},
          {"key", reference(id + "/file_name")},
          {"field", fields}};
}

}  // namespace

std::string missing_in_croissant(const ExportOptions& options) {
  std::string names;
  for (const auto& [name, value] : options.publication())
    if (value->empty()) names += (names.empty() ? "--" : ", --") + std::string(name);
  return names;
}

nlohmann::ordered_json croissant(const ExportJob& job, const std::vector<HuggingFaceSplit>& splits) {
  const ExportOptions& options = job.options;
  Json json = {{"@context", context()},
               {"@type", "sc:Dataset"},
               {"conformsTo", "http://mlcommons.org/croissant/1.1"},
               {"name", job.source.name},
               {"description", dataset_description(job.source)}};
  if (!options.license.empty()) json["license"] = {{"@type", "sc:CreativeWork"}, {"name", options.license}};
  if (!options.url.empty()) json["url"] = options.url;
  if (!options.creator.empty()) json["creator"] = {{"@type", "sc:Organization"}, {"name", options.creator}};
  if (!options.published.empty()) json["datePublished"] = options.published;
  Json files = Json::array(), record_sets = Json::array();
  for (const HuggingFaceSplit& split : splits) {
    add_files(files, job.source, split);
    record_sets.push_back(labels_set(split));
    record_sets.push_back(images_set(job.source, split));
  }
  json["distribution"] = files;
  json["recordSet"] = record_sets;
  return json;
}

}  // namespace cps
