#include "dataset/job/records.h"

#include "files/json_keys.h"

namespace cps {

namespace {

nlohmann::ordered_json to_json(const ImageRecord& image) {
  nlohmann::ordered_json json = {{"file", image.file},
                                 {"exposure_bias_ev", image.sensor.exposure_bias_ev},
                                 {"full_well_e", image.sensor.full_well_e},
                                 {"read_noise_e", image.sensor.read_noise_e},
                                 {"bytes", image.bytes},
                                 {"sha256", image.sha256},
                                 {"pixels_sha256", image.pixels_sha256}};
  for (const DenseRecord& dense : image.dense)
    json["dense"].push_back(
        {{"label", to_string(dense.label)}, {"bytes", dense.bytes}, {"sha256", dense.sha256}});
  return json;
}

DenseLabel dense_label_in(const JsonKeys& keys) {
  const std::string name = keys.text("label");
  try {
    return dense_label_from(name);
  } catch (const std::runtime_error& error) {
    keys.fail("label", error.what());
  }
}

std::vector<DenseRecord> dense_from_json(const JsonKeys& image, const std::string& file) {
  if (!image.at("dense").is_array()) image.fail("dense", "must be a list");
  std::vector<DenseRecord> records;
  for (const nlohmann::json& entry : image.at("dense")) {
    const JsonKeys dense{entry, file};
    records.push_back({dense_label_in(dense), dense.unsigned_integer("bytes"), dense.text("sha256")});
  }
  return records;
}

}  // namespace

nlohmann::ordered_json to_json(const ViewRecord& record) {
  nlohmann::ordered_json images = nlohmann::json::array();
  for (const ImageRecord& image : record.images) images.push_back(to_json(image));
  nlohmann::ordered_json json = {{"view", record.view}, {"exposure", record.exposure}, {"images", images}};
  if (record.master)
    json["master"] = {
        {"file", record.master->file}, {"bytes", record.master->bytes}, {"sha256", record.master->sha256}};
  return json;
}

ViewRecord view_record_from_json(const nlohmann::json& json, const std::string& file) {
  const JsonKeys keys{json, file};
  ViewRecord record{.view = static_cast<std::int64_t>(keys.unsigned_integer("view")),
                    .exposure = keys.number("exposure"),
                    .images = {}};
  if (!keys.at("images").is_array()) keys.fail("images", "must be a list");
  for (const nlohmann::json& entry : keys.at("images")) {
    const JsonKeys image{entry, file};
    record.images.push_back({.file = image.text("file"),
                             .sensor = {.exposure_bias_ev = image.number("exposure_bias_ev"),
                                        .full_well_e = image.number("full_well_e"),
                                        .read_noise_e = image.number("read_noise_e")},
                             .bytes = image.unsigned_integer("bytes"),
                             .sha256 = image.text("sha256"),
                             .pixels_sha256 = image.text("pixels_sha256")});
    if (entry.contains("dense")) record.images.back().dense = dense_from_json(image, file);
  }
  if (json.contains("master")) {
    const JsonKeys master{keys.at("master"), file};
    record.master = {.file = master.text("file"),
                     .bytes = master.unsigned_integer("bytes"),
                     .sha256 = master.text("sha256")};
  }
  return record;
}

}  // namespace cps
