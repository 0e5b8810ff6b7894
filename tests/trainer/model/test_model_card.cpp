#include <catch2/catch.hpp>

#include "files/files.h"
#include "tests/temporary_folder.h"
#include "trainer/model/model_card.h"

using namespace cps;

namespace {

ModelCard card_with_orientation() {
  ModelCard card;
  card.options.orientation = {.measured = true, .max_width = 696};
  for (int i = 0; i < orientation_plane_count; ++i) {
    card.orientation.plane_mean[i] = .25 + i;
    card.orientation.plane_deviation[i] = .5 + i;
  }
  for (int i = 0; i < orientation_number_count; ++i) {
    card.orientation.number_mean[i] = .125 + i;
    card.orientation.number_deviation[i] = .75 + i;
  }
  return card;
}

}  // namespace

TEST_CASE("a card keeps how the orientation is normalised") {
  const TemporaryFolder folder;
  const ModelCard card = card_with_orientation();
  save_model_card(card, folder.path);
  const ModelCard read = load_model_card(folder.path);
  CHECK(read.options == card.options);
  CHECK(read.orientation.plane_mean == card.orientation.plane_mean);
  CHECK(read.orientation.plane_deviation == card.orientation.plane_deviation);
  CHECK(read.orientation.number_mean == card.orientation.number_mean);
  CHECK(read.orientation.number_deviation == card.orientation.number_deviation);

  nlohmann::ordered_json json = nlohmann::ordered_json::parse(read_file(folder.path / "model.json"));
  nlohmann::ordered_json older = json;
  older["input"]["orientation"].erase("version");
  write_json(folder.path / "model.json", older);
  CHECK_THROWS_WITH(load_model_card(folder.path), Catch::Contains("measured by another version"));
  json["input"]["orientation"]["numbers"]["names"][3] = "something else";
  write_json(folder.path / "model.json", json);
  CHECK_THROWS_WITH(load_model_card(folder.path), Catch::Contains("numbers.names"));
  json["input"].erase("orientation");
  write_json(folder.path / "model.json", json);
  CHECK_THROWS_WITH(load_model_card(folder.path), Catch::Contains("orientation"));
}

TEST_CASE("a card says that weights are float16 and of others it says nothing") {
  const TemporaryFolder folder;
  ModelCard card;
  save_model_card(card, folder.path);
  const std::string before = read_file(folder.path / "model.json");
  CHECK_THAT(before, !Catch::Contains("\"weights\"") && !Catch::Contains("float16"));
  CHECK_FALSE(load_model_card(folder.path).has_half_weights);

  card.has_half_weights = true;
  save_model_card(card, folder.path);
  CHECK(load_model_card(folder.path).has_half_weights);
  auto json = nlohmann::ordered_json::parse(read_file(folder.path / "model.json"));
  CHECK(json.at("weights") == "float16");
  json.erase("weights");
  CHECK(json.dump(2) + "\n" == before);

  json["weights"] = "float8";
  write_json(folder.path / "model.json", json);
  CHECK_THROWS_WITH(load_model_card(folder.path), Catch::Contains("weights: is not float16"));
}

TEST_CASE("the card of a network without orientation does not mention it") {
  const TemporaryFolder folder;
  save_model_card({}, folder.path);
  CHECK_THAT(read_file(folder.path / "model.json"), !Catch::Contains("orientation"));
  CHECK(load_model_card(folder.path).options == TrainOptions{});
}
