#pragma once

#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "dataset/dense/dense_file.h"
#include "dataset/labels/reader.h"
#include "files/files.h"
#include "random/counter_hash.h"
#include "tests/dataset/edit_csv.h"

/// Dense labels for a dataset that has none: files beside the images, columns of frames.csv and the classes
/// in dataset.json.
namespace cps {

inline constexpr std::array all_dense_labels = {
    DenseLabel::depth,    DenseLabel::distance, DenseLabel::normal, DenseLabel::instance,
    DenseLabel::semantic, DenseLabel::rays,     DenseLabel::up,     DenseLabel::latitude};

/// Some of Cityscapes' classes.
inline nlohmann::json some_classes() {
  const auto entry = [](int id, const char* name) {
    return nlohmann::json{{"id", id}, {"name", name}, {"has_instances", id >= 24}};
  };
  return {entry(7, "road"),   entry(11, "building"), entry(23, "sky"),    entry(24, "person"),
          entry(25, "rider"), entry(26, "car"),      entry(33, "bicycle")};
}

/// Objects in blocks, some of them as high as the image, with single pixels of object 7 strewn over them. The
/// pixels of object 2 belong to two classes in turn.
struct MadeUpObjects {
  Stream stream;

  std::uint16_t instance(std::uint64_t x, std::uint64_t y) const {
    if (random_below(substream(stream, 0), 1000 * y + x, 50) == 0) return 7;
    const std::uint64_t column = x / 8;
    const bool is_high = random_below(substream(stream, 1), column, 4) == 0;
    const std::uint64_t block = is_high ? column : 100 + column + 8 * (y / 6);
    return static_cast<std::uint16_t>(random_below(substream(stream, 2), block, 7));
  }
  std::uint16_t semantic(std::uint64_t x, std::uint64_t y) const {
    constexpr std::array<std::uint16_t, 8> class_of = {23, 26, 25, 7, 11, 24, 26, 26};
    const std::uint16_t object = instance(x, y);
    return object == 2 && (x + y) % 3 == 0 ? 33 : class_of[object];
  }
};

/// The pixels of a label of the image with this number: noise, or the made-up objects.
inline OIIO::ImageBuf made_up_label(DenseLabel label, const Pinhole& camera, std::uint64_t image) {
  OIIO::ImageBuf pixels(dense_spec(label, {camera.width, camera.height}));
  const Stream stream = substream(make_stream(9, "dense"), image);
  if (label == DenseLabel::instance || label == DenseLabel::semantic) {
    const MadeUpObjects objects{stream};
    auto* value = static_cast<std::uint16_t*>(pixels.localpixels());
    for (int y = 0; y < camera.height; ++y)
      for (int x = 0; x < camera.width; ++x)
        *value++ = label == DenseLabel::instance ? objects.instance(x, y) : objects.semantic(x, y);
    return pixels;
  }
  const Stream noise = substream(stream, 10 + static_cast<std::uint64_t>(label));
  auto* value = static_cast<float*>(pixels.localpixels());
  for (std::uint64_t i = 0; i < pixels.spec().image_pixels() * pixels.nchannels(); ++i)
    value[i] = static_cast<float>(random_uniform(noise, i, -1, 1));
  return pixels;
}

/// Gives every scene of the dataset these classes.
inline void write_classes(const std::filesystem::path& root, const nlohmann::json& classes) {
  nlohmann::json description = read_json(root / "dataset.json");
  for (nlohmann::json& scene : description.at("scenes")) scene["classes"] = classes;
  write_file(root / "dataset.json", description.dump(2));
}

inline void add_dense_labels(const std::filesystem::path& root,
                             std::span<const DenseLabel> labels = all_dense_labels) {
  const Dataset dataset = read_dataset(root);
  std::map<std::string, std::string> hashes;
  for (std::size_t i = 0; i < dataset.images.size(); ++i)
    for (DenseLabel label : labels) {
      const DatasetImage& image = dataset.images[i];
      const Pinhole& camera = dataset.groups[image.group].label.camera;
      const std::string bytes = encode_dense(made_up_label(label, camera, i), label);
      write_file(root / dense_file(image.file, label), bytes);
      hashes[dense_file(image.file, label).string()] = sha256(bytes);
    }
  for (const DatasetGroup& group : dataset.groups) {
    CsvTable table = read_csv(root / group.folder / "frames.csv");
    const std::size_t file = table.column("file");
    for (DenseLabel label : labels) {
      table.header.push_back(to_string(label) + "_sha256");
      for (std::vector<std::string>& row : table.rows)
        row.push_back(hashes.at((group.folder / dense_file(row[file], label)).string()));
    }
    write_csv(table);
  }
  write_classes(root, some_classes());
}

}  // namespace cps
