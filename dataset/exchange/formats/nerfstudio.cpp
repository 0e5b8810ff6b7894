#include <algorithm>
#include <array>
#include <stdexcept>

#include "dataset/exchange/formats/formats.h"

/// The transforms.json of nerfstudio (`camera_model`) and instant-ngp (`is_fisheye`), cameras only.
/// Intrinsics stand at the top level, or in a frame, where they override those of the top level. Fisheye
/// lenses are k1 k2 k3 k4. The centre of the top-left pixel is (.5, .5).
namespace cps {
namespace {

constexpr std::array intrinsics{"camera_model", "is_fisheye", "fl_x", "fl_y", "cx", "cy", "w", "h",
                                "k1",           "k2",         "k3",   "k4",   "p1", "p2"};

LensModel read_lens(const JsonKeys& keys) {
  const auto optional = [&](const char* key) { return keys.json.contains(key) ? keys.number(key) : 0.0; };
  if (named_lens(keys, {NamedLens::plane, NamedLens::kannala_brandt}) == NamedLens::plane) {
    refuse_other_coefficients(keys, {"k1", "k2", "k3", "p1", "p2"});
    return Distortion{.k1 = optional("k1"),
                      .k2 = optional("k2"),
                      .k3 = optional("k3"),
                      .p1 = optional("p1"),
                      .p2 = optional("p2")};
  }
  const bool is_named = keys.json.contains("camera_model");
  if (is_named &&
      lens_of_name(keys.text("camera_model"), keys.file + ": camera_model") != NamedLens::kannala_brandt)
    keys.fail("camera_model", "names no fisheye, but is_fisheye does: keep one of them");
  refuse_other_coefficients(keys, {"k1", "k2", "k3", "k4"});
  const KannalaBrandt lens{
      .k1 = optional("k1"), .k2 = optional("k2"), .k3 = optional("k3"), .k4 = optional("k4")};
  if (lens == KannalaBrandt{} && !is_named)
    keys.fail("is_fisheye",
              "is given without coefficients, which instant-ngp takes for a pinhole: say camera_model "
              "OPENCV_FISHEYE, or remove is_fisheye");
  return lens;
}

ModelCamera read_nerfstudio_camera(const JsonKeys& keys, const std::string& name) {
  const auto pixels = [&](const char* key) { return size_px(keys.number(key), keys.file + ": " + key); };
  const double fx = keys.number("fl_x");
  return {name,
          {.width = pixels("w"),
           .height = pixels("h"),
           .fx = fx,
           .fy = keys.json.contains("fl_y") ? keys.number("fl_y") : fx,
           .cx = keys.number("cx") - 0.5,
           .cy = keys.number("cy") - 0.5},
          read_lens(keys)};
}

nlohmann::ordered_json pinhole_keys(const Pinhole& pinhole) {
  return {{"fl_x", pinhole.fx},     {"fl_y", pinhole.fy}, {"cx", pinhole.cx + 0.5},
          {"cy", pinhole.cy + 0.5}, {"w", pinhole.width}, {"h", pinhole.height}};
}

nlohmann::ordered_json camera_keys(const ModelCamera& camera) {
  const auto* fisheye = std::get_if<KannalaBrandt>(&camera.lens);
  if (fisheye == nullptr)
    return nerfstudio_camera({camera.name, camera.pinhole, std::get<Distortion>(camera.lens)});
  // Without p1 and p2: instant-ngp would take them for k3 and k4.
  nlohmann::ordered_json json = pinhole_keys(camera.pinhole);
  for (const auto& [name, value] : parameters(*fisheye)) json[std::string(name)] = value;
  return json;
}

}  // namespace

ModelCalibrationFile read_nerfstudio(const JsonKeys& root, const std::string& name) {
  ModelCalibrationFile file;
  const nlohmann::json frames = root.json.value("frames", nlohmann::json::array());
  nlohmann::json top = root.json;
  top.erase("frames");
  for (const nlohmann::json& frame : frames) {
    const auto overrides = [&](const char* key) { return frame.contains(key); };
    if (!frame.is_object() || std::none_of(intrinsics.begin(), intrinsics.end(), overrides)) continue;
    nlohmann::json merged = top;
    merged.update(frame);
    const std::string path = JsonKeys{frame, root.file}.text("file_path"), where = root.file + ": " + path;
    add_camera(file, path, [&] { return read_nerfstudio_camera(JsonKeys{merged, where}, path); });
  }
  if (file.cameras.empty() && file.unread.empty())
    file.cameras.push_back(read_nerfstudio_camera(JsonKeys{top, root.file}, name));
  return file;
}

nlohmann::ordered_json nerfstudio_camera(const CalibratedCamera& camera) {
  const Distortion& lens = camera.distortion;
  nlohmann::ordered_json json = pinhole_keys(camera.pinhole);
  json.update(nlohmann::ordered_json{
      {"k1", lens.k1}, {"k2", lens.k2}, {"k3", lens.k3}, {"p1", lens.p1}, {"p2", lens.p2}});
  return json;
}

std::string write_nerfstudio(CameraSpan cameras) {
  const auto is_fisheye = [](const ModelCamera& camera) {
    return std::holds_alternative<KannalaBrandt>(camera.lens);
  };
  const bool all_fisheye = std::ranges::all_of(cameras, is_fisheye);
  if (!all_fisheye && std::ranges::any_of(cameras, is_fisheye))
    throw std::runtime_error("nerfstudio holds cameras of one lens model: write the others to another file");
  nlohmann::ordered_json json = {{"camera_model", all_fisheye ? "OPENCV_FISHEYE" : "OPENCV"}};
  if (all_fisheye) json["is_fisheye"] = true;
  if (cameras.size() == 1) json.update(camera_keys(cameras.front()));
  json["frames"] = nlohmann::ordered_json::array();
  if (cameras.size() > 1)
    for (const ModelCamera& camera : cameras) {
      nlohmann::ordered_json frame = {{"file_path", camera.name}};
      frame.update(camera_keys(camera));
      json["frames"].push_back(frame);
    }
  return json.dump(2) + "\n";
}

}  // namespace cps
