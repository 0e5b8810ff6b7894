#include <yaml-cpp/yaml.h>

#include <catch2/catch.hpp>
#include <set>
#include <sstream>

#include "tests/dataset/export/exported.h"

using namespace cps;
namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

std::vector<Json> lines_of(const fs::path& file) {
  std::vector<Json> lines;
  std::istringstream text(read_file(file));
  for (std::string line; std::getline(text, line);) lines.push_back(Json::parse(line));
  return lines;
}

/// The YAML between the first two lines `---` of README.md.
YAML::Node card_of(const fs::path& out) {
  const std::string card = read_file(out / "README.md");
  REQUIRE_THAT(card, Catch::StartsWith("---\n"));
  return YAML::Load(card.substr(4, card.find("\n---\n") - 4));
}

const char* yaml_type(const Json& value) {
  if (value.is_string()) return "string";
  return value.is_number_float() ? "float64" : "int64";
}

/// Every @id that is defined or referred to, wherever it stands.
void collect_ids(const Json& json, std::set<std::string>& defined, std::set<std::string>& referred) {
  if (json.is_object() && json.contains("@id") && json.at("@id").is_string())
    (json.size() == 1 ? referred : defined).insert(json.at("@id").get<std::string>());
  if (json.is_structured())
    for (const auto& value : json) collect_ids(value, defined, referred);
}

}  // namespace

TEST_CASE("each split has its images and a line of metadata for each, the file's name first") {
  const Exported exported(ExportTarget::huggingface);
  const Dataset dataset = read_dataset(exported.root);
  for (const char* part : {"train", "val", "test"}) {
    std::vector<const DatasetImage*> images;
    for (const DatasetImage& image : dataset.images)
      if (to_string(image.part) == part) images.push_back(&image);
    const std::vector<Json> lines = lines_of(exported.out / part / "metadata.jsonl");
    REQUIRE(lines.size() == images.size());
    for (std::size_t i = 0; i < images.size(); ++i) {
      CHECK(lines[i].at("file_name") == images[i]->file.string());
      CHECK(lines[i].at("k1") == dataset.groups[images[i]->group].label.distortion.k1);
      CHECK(read_file(exported.out / part / images[i]->file) == read_file(exported.root / images[i]->file));
    }
  }
  CHECK_THAT(read_file(exported.out / "train/metadata.jsonl"), Catch::StartsWith("{\"file_name\":\""));
}

TEST_CASE("the card's YAML names the splits, and a type for every column of the metadata") {
  const Exported exported;
  exported.write(exported.out, {.target = ExportTarget::huggingface, .license = "cc-by-4.0"});
  const YAML::Node card = card_of(exported.out);
  CHECK(card["license"].as<std::string>() == "cc-by-4.0");
  CHECK(card["pretty_name"].as<std::string>() == "small");
  CHECK(card["size_categories"][0].as<std::string>() == "n<1K");
  const YAML::Node files = card["configs"][0]["data_files"], splits = card["dataset_info"]["splits"];
  const std::vector<std::string> parts = {"train", "val", "test"};
  REQUIRE(files.size() == parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p) {
    CHECK(files[p]["split"].as<std::string>() == parts[p]);
    CHECK(files[p]["path"].as<std::string>() == parts[p] + "/**");
    CHECK(splits[p]["name"].as<std::string>() == parts[p]);
    CHECK(splits[p]["num_examples"].as<std::size_t>() ==
          lines_of(exported.out / parts[p] / "metadata.jsonl").size());
  }
  const YAML::Node features = card["dataset_info"]["features"];
  CHECK(features[0]["name"].as<std::string>() == "image");
  CHECK(features[0]["dtype"].as<std::string>() == "image");
  std::map<std::string, std::string> types;
  for (std::size_t i = 1; i < features.size(); ++i)
    types[features[i]["name"].as<std::string>()] = features[i]["dtype"].as<std::string>();
  for (Json line : lines_of(exported.out / "train/metadata.jsonl")) {
    line.erase("file_name");
    CHECK(line.size() == types.size());
    for (const auto& [key, value] : line.items()) {
      INFO(key);
      CHECK(types[key] == yaml_type(value));
    }
  }
}

TEST_CASE("without a licence the card and croissant.json name none, and a note says what is missing") {
  const Exported exported;
  const ExportSummary summary = exported.write(exported.out, {.target = ExportTarget::huggingface});
  CHECK_THAT(summary.note, Catch::EndsWith("--license, --url, --creator, --published"));
  CHECK_FALSE(card_of(exported.out)["license"]);
  const Json croissant = read_json(exported.out / "croissant.json");
  for (const char* key : {"license", "url", "creator", "datePublished"}) CHECK_FALSE(croissant.contains(key));
}

TEST_CASE(
    "croissant.json has what version 1.1 requires, hashes that are right and references that lead somewhere") {
  const Exported exported;
  CHECK(exported
            .write(exported.out, {.target = ExportTarget::huggingface,
                                  .license = "cc0-1.0",
                                  .url = "https://example.org/data",
                                  .creator = "A \"Lab\"",
                                  .published = "2026-05-02"})
            .note.empty());
  const Json croissant = read_json(exported.out / "croissant.json");
  CHECK(croissant.at("@type") == "sc:Dataset");
  CHECK(croissant.at("conformsTo") == "http://mlcommons.org/croissant/1.1");
  for (const char* key : {"@context", "name", "description", "license", "url", "creator", "datePublished"})
    CHECK(croissant.contains(key));
  CHECK(croissant.at("creator").at("name") == "A \"Lab\"");

  std::set<std::string> defined, referred;
  for (const char* key : {"distribution", "recordSet"}) collect_ids(croissant.at(key), defined, referred);
  for (const std::string& id : referred) {
    INFO(id);
    CHECK(defined.contains(id));
  }
  int files = 0, sets = 0;
  for (const Json& resource : croissant.at("distribution")) {
    if (resource.at("@type") == "cr:FileObject") {
      const std::string bytes = read_file(exported.out / resource.at("contentUrl").get<std::string>());
      CHECK(resource.at("sha256") == sha256(bytes));
      CHECK(resource.at("contentSize") == std::to_string(bytes.size()) + " B");
      ++files;
    } else {
      CHECK(resource.at("@type") == "cr:FileSet");
      CHECK_THAT(resource.at("includes").get<std::string>(), Catch::EndsWith("/**/*.png"));
      ++sets;
    }
  }
  CHECK(files == 3);
  CHECK(sets == 3);
}

TEST_CASE("croissant.json describes the image and every column of each split") {
  const Exported exported(ExportTarget::huggingface);
  const Json croissant = read_json(exported.out / "croissant.json");
  for (const std::string part : {"train", "val", "test"}) {
    const Json line = lines_of(exported.out / part / "metadata.jsonl").front();
    std::map<std::string, Json> fields;
    for (const Json& set : croissant.at("recordSet"))
      if (set.at("@id") == part)
        for (const Json& field : set.at("field")) fields[field.at("name")] = field;
    CHECK(fields.at("image").at("dataType") == "sc:ImageObject");
    CHECK(fields.size() == line.size() + 1);
    for (const auto& [key, value] : line.items()) {
      INFO(key);
      REQUIRE(fields.contains(key));
      CHECK_FALSE(fields[key].at("description").get<std::string>().empty());
      CHECK(fields[key].at("dataType") == (value.is_string()         ? "sc:Text"
                                           : value.is_number_float() ? "sc:Float"
                                                                     : "sc:Integer"));
    }
    CHECK(fields["k1"]["source"]["extract"]["column"] == "k1");
    CHECK(fields["k1"]["source"]["fileObject"]["@id"] == part + "/metadata.jsonl");
  }
}

TEST_CASE("dense labels lie apart from the images, and the card and croissant.json tell of them") {
  const Labelled exported(ExportTarget::huggingface);
  const Dataset dataset = read_dataset(exported.root);
  std::map<std::string, std::size_t> images;
  for (const DatasetImage& image : dataset.images) {
    const std::string part = to_string(image.part);
    ++images[part];
    for (DenseLabel label : all_dense_labels) {
      const fs::path file = dense_file(image.file, label);
      CHECK(fs::equivalent(exported.out / "dense" / part / file, exported.root / file));
    }
  }
  const auto files = bytes_of(exported.out);
  const std::string card = read_file(exported.out / "README.md");
  std::map<std::string, Json> sets;
  const Json croissant = read_json(exported.out / "croissant.json");
  for (const Json& resource : croissant.at("distribution"))
    if (resource.at("@type") == "cr:FileSet") sets[resource.at("@id")] = resource;
  CHECK(sets.size() == 3 * (1 + all_dense_labels.size()));
  for (const auto& [part, count] : images) {
    CHECK(bytes_of(exported.out / part).size() == count + 1);  // what the card's data_files name
    for (DenseLabel label : all_dense_labels) {
      const Json& set = sets.at(part + "-" + to_string(label));
      const std::string includes = set.at("includes"), wild = "**/*";
      const std::size_t at = includes.find(wild);
      REQUIRE(at != std::string::npos);
      std::size_t included = 0;
      for (const auto& [name, bytes] : files)
        included +=
            name.starts_with(includes.substr(0, at)) && name.ends_with(includes.substr(at + wild.size()));
      CHECK(included == count);
      CHECK(set.at("encodingFormat") == (includes.ends_with(".png") ? "image/png" : "image/x-exr"));
      CHECK_THAT(card,
                 Catch::Contains("| " + to_string(label) + " | `dense/train/000017." + to_string(label)));
    }
  }
  CHECK(read_json(exported.out / "dense/classes.json").at("scenes").begin().value() == some_classes());
  CHECK_THAT(read_file(Exported(ExportTarget::huggingface).out / "README.md"),
             !Catch::Contains("Dense labels"));
}

TEST_CASE("a JSON-LD processor finds Croissant's terms in croissant.json, without a network", "[slow]") {
  const Exported exported(ExportTarget::huggingface);
  const std::string in_folder = "cd " + exported.temporary.path.string() + " && ";
  if (std::system((in_folder + "npm install --silent jsonld@8 > npm.log 2>&1").c_str()) != 0)
    FAIL("npm could not install jsonld: install npm and allow it to reach its registry");
  write_file(exported.temporary.path / "expand.js", std::string(R"(
    const jsonld = require('jsonld'), fs = require('fs'), assert = require('assert');
    const cr = 'http://mlcommons.org/croissant/', sc = 'http://schema.org/', base = 'https://example.org/data/';
    const documentLoader = url => { throw new Error('would load ' + url); };
    const document = JSON.parse(fs.readFileSync('out/croissant.json'));
    jsonld.expand(document, {base, documentLoader, safe: true}).then(([dataset]) => {
      assert.deepEqual(dataset['@type'], [sc + 'Dataset']);
      assert.equal(dataset['http://purl.org/dc/terms/conformsTo'][0]['@value'], cr + '1.1');
      const files = dataset[sc + 'distribution'], sets = dataset[cr + 'recordSet'];
      assert.equal(files.filter(f => f['@type'][0] === cr + 'FileObject').length, 3);
      assert.equal(files.filter(f => f['@type'][0] === cr + 'FileSet').length, 3);
      for (const file of files)
        if (file['@type'][0] === cr + 'FileObject') assert.match(file[sc + 'sha256'][0]['@value'], /^[0-9a-f]{64}$/);
        else assert(file[cr + 'includes'][0]['@value']);
      const sources = new Set(files.map(file => file['@id']));
      assert.equal(sets.length, 6);
      for (const set of sets) {
        const fields = set[cr + 'field'];
        assert(fields.some(field => field['@id'] === set[cr + 'key'][0]['@id']));
        for (const field of fields) {
          assert(field['@id'].startsWith(set['@id'] + '/'));
          assert(field[cr + 'dataType'][0]['@id'].startsWith(sc));
          const source = field[cr + 'source'][0];
          assert(sources.has((source[cr + 'fileObject'] || source[cr + 'fileSet'])[0]['@id']));
          assert(source[cr + 'extract'][0][cr + 'column'] || source[cr + 'extract'][0][cr + 'fileProperty']);
        }
      }
    }).catch(error => { console.error(error.message); process.exit(1); });)"));
  CHECK(std::system((in_folder + "node expand.js").c_str()) == 0);
}
