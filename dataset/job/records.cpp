#include "dataset/job/records.h"

#include "files/json_keys.h"

namespace cps {

nlohmann::ordered_json to_json(const ViewRecord& record) {
  nlohmann::ordered_json images = nlohmann::json::array();
  for (const ImageRecord& image : record.images)
    images.push_back({{"file", image.file},
                      {"exposure_bias_ev", image.sensor.exposure_bias_ev},
                      {"full_well_e", image.sensor.full_well_e},
                      {"read_noise_e", image.sensor.read_noise_e},
                      {"bytes", image.bytes},
                      {"sha256", image.sha256},
                      {"pixels_sha256", image.pixels_sha256}});
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
