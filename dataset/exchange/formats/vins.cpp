#include "dataset/exchange/formats/formats.h"

/// VINS and camodocal: model_type PINHOLE with projection_parameters fx fy cx cy and distortion_parameters
/// k1 k2 p1 p2. Other model types (MEI, KANNALA_BRANDT, SCARAMUZZA) use the same key names.
namespace cps {

CalibratedCamera read_vins(const JsonKeys& root, const std::string& name) {
  refuse_other_models(root, {});
  const JsonKeys projection{root.at("projection_parameters"), root.file};
  refuse_other_models(projection, {});
  nlohmann::json none = nlohmann::json::object();
  const bool has_lens = root.json.contains("distortion_parameters");
  const JsonKeys lens{has_lens ? root.at("distortion_parameters") : none, root.file};
  refuse_other_models(lens, {"k1", "k2", "p1", "p2"});
  const auto optional = [&](const char* key) { return lens.json.contains(key) ? lens.number(key) : 0.0; };
  return {root.json.contains("camera_name") ? name_at(root, "camera_name") : name,
          {.width = root.pixels("image_width"),
           .height = root.pixels("image_height"),
           .fx = projection.number("fx"),
           .fy = projection.number("fy"),
           .cx = projection.number("cx"),
           .cy = projection.number("cy")},
          {.k1 = optional("k1"), .k2 = optional("k2"), .p1 = optional("p1"), .p2 = optional("p2")}};
}

}  // namespace cps
