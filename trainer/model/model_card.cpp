#include "trainer/model/model_card.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <stdexcept>
#include <vector>

#include "files/files.h"

namespace cps {
namespace {

constexpr std::array<const char*, orientation_plane_count> plane_names{
    "vertical_tilt_times_confidence", "horizontal_tilt_times_confidence", "vertical_confidence",
    "horizontal_confidence"};

/// What a card says of weights that half_weights_of() made. Of others it says nothing, so older cards stay
/// valid.
constexpr const char* half_word = "float16";

/// Of how orientation is measured; 1 did not weigh edges by their coherence and wrote no version.
constexpr int orientation_version = 2;

nlohmann::ordered_json to_json(const OrientationStatistics& statistics) {
  return {
      {"version", orientation_version},
      {"planes",
       {{"names", plane_names}, {"mean", statistics.plane_mean}, {"deviation", statistics.plane_deviation}}},
      {"numbers",
       {{"names", orientation_number_names},
        {"mean", statistics.number_mean},
        {"deviation", statistics.number_deviation}}}};
}

OrientationStatistics orientation_statistics_from_json(const nlohmann::json& json) {
  OrientationStatistics statistics;
  if (json.value("version", 1) != orientation_version)
    throw std::runtime_error("input.orientation: was measured by another version");
  if (json.at("numbers").at("names") != nlohmann::json(orientation_number_names))
    throw std::runtime_error("input.orientation.numbers.names: are those of another version");
  json.at("planes").at("mean").get_to(statistics.plane_mean);
  json.at("planes").at("deviation").get_to(statistics.plane_deviation);
  json.at("numbers").at("mean").get_to(statistics.number_mean);
  json.at("numbers").at("deviation").get_to(statistics.number_deviation);
  const auto is_positive = [](double deviation) { return deviation > 0; };
  if (!std::ranges::all_of(statistics.plane_deviation, is_positive) ||
      !std::ranges::all_of(statistics.number_deviation, is_positive))
    throw std::runtime_error("input.orientation: deviation: must be above 0");
  return statistics;
}

nlohmann::ordered_json outputs_json(const ModelCard& card) {
  if (!is_deepcalib(card.options.head)) {
    nlohmann::ordered_json json{
        {"names", output_names}, {"mean", card.targets.mean}, {"deviation", card.targets.deviation}};
    if (is_fit(card.options.head)) {
      json["correlation"] =
          std::vector<double>(card.correlation.data(), card.correlation.data() + card.correlation.size());
      json["deviation_scale"] = card.deviation_scale;
    }
    return json;
  }
  const auto pair = [](const SphereTarget& target) { return std::array{target.focal, target.xi}; };
  return {{"names", sphere_output_names},
          {"mean", pair(card.spheres.mean)},
          {"deviation", pair(card.spheres.deviation)}};
}

void read_outputs(const nlohmann::json& json, ModelCard& card) {
  if (!is_deepcalib(card.options.head)) {
    json.at("mean").get_to(card.targets.mean);
    json.at("deviation").get_to(card.targets.deviation);
    if (!is_fit(card.options.head)) return;
    json.at("deviation_scale").get_to(card.deviation_scale);
    const auto numbers = json.at("correlation").get<std::array<double, output_count * output_count>>();
    card.correlation = OutputCovariance::Map(numbers.data());
    if (Eigen::LLT<OutputCovariance>(card.correlation).info() != Eigen::Success)
      throw std::runtime_error("outputs.correlation: is not positive definite");
    return;
  }
  const auto pair = [&](const char* key) {
    const auto numbers = json.at(key).get<std::array<double, 2>>();
    return SphereTarget{numbers[0], numbers[1]};
  };
  card.spheres = {pair("mean"), pair("deviation")};
}

}  // namespace

void save_model_card(const ModelCard& card, const std::filesystem::path& model_folder) {
  nlohmann::ordered_json json{
      {"schema", model_schema},
      {"options", to_json(card.options)},
      {"input",
       {{"channels", "gray"}, {"pixel_mean", card.pixels.mean}, {"pixel_deviation", card.pixels.deviation}}},
      {"outputs", outputs_json(card)},
      {"dataset",
       {{"folder", card.dataset},
        {"hash", card.dataset_hash},
        {"training_images", card.training_images},
        {"validation_images", card.validation_images}}},
      {"epoch", card.epoch},
      {"validation_loss", card.validation_loss}};
  if (card.options.orientation.measured) json["input"]["orientation"] = to_json(card.orientation);
  if (card.has_half_weights) json["weights"] = half_word;
  write_json(model_folder / "model.json", json);
}

ModelCard load_model_card(const std::filesystem::path& model_folder) {
  const std::filesystem::path file = model_folder / "model.json";
  if (!std::filesystem::exists(file))
    throw std::runtime_error(file.string() + ": is missing: name a folder that cps train has written");
  const nlohmann::json json = read_json(file);
  try {
    if (json.at("schema") != model_schema)
      throw std::runtime_error("schema is not " + std::to_string(model_schema));
    ModelCard card;
    card.options = train_options_from_json(json.at("options"));
    json.at("input").at("pixel_mean").get_to(card.pixels.mean);
    json.at("input").at("pixel_deviation").get_to(card.pixels.deviation);
    if (card.options.orientation.measured)
      card.orientation = orientation_statistics_from_json(json.at("input").at("orientation"));
    read_outputs(json.at("outputs"), card);
    json.at("dataset").at("folder").get_to(card.dataset);
    json.at("dataset").at("hash").get_to(card.dataset_hash);
    json.at("dataset").at("training_images").get_to(card.training_images);
    json.at("dataset").at("validation_images").get_to(card.validation_images);
    json.at("epoch").get_to(card.epoch);
    json.at("validation_loss").get_to(card.validation_loss);
    card.has_half_weights = json.contains("weights");
    if (card.has_half_weights && json.at("weights") != half_word)
      throw std::runtime_error(std::string("weights: is not ") + half_word);
    if (const std::string fault = card.options.fault(); !fault.empty()) throw std::runtime_error(fault);
    return card;
  } catch (const std::exception& e) {
    throw std::runtime_error(file.string() + ": " + e.what() + ": restore the file or train again");
  }
}

}  // namespace cps
