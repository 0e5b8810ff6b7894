#include <OpenImageIO/imageio.h>

#include <catch2/catch.hpp>
#include <limits>
#include <utility>

#include "dataset/dense/dense_file.h"
#include "dataset/pixels/image_file.h"
#include "files/files.h"
#include "random/counter_hash.h"
#include "tests/same_bytes.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

constexpr ImageSize size = {37, 21};  // more than the 16 lines that EXR packs together

std::vector<DenseLabel> all_labels() {
  std::vector<DenseLabel> labels;
  for (const char* name : dense_label_names) labels.push_back(dense_label_from(name));
  return labels;
}

bool is_png(DenseLabel label) {
  return label == DenseLabel::instance || label == DenseLabel::semantic;
}

/// Noise of all the numbers that floats, and that ids, can hold; the extremes first.
OIIO::ImageBuf extremes_and_noise(DenseLabel label) {
  OIIO::ImageBuf image(dense_spec(label, size));
  const std::size_t values = image.spec().image_pixels() * image.nchannels();
  const Stream stream = make_stream(static_cast<std::uint64_t>(label), "dense");
  if (is_png(label)) {
    auto* ids = static_cast<std::uint16_t*>(image.localpixels());
    for (std::size_t i = 0; i < values; ++i) ids[i] = static_cast<std::uint16_t>(random_bits(stream, i));
    ids[0] = 65535, ids[1] = 0, ids[2] = 255, ids[3] = 256;
  } else {
    using Limits = std::numeric_limits<float>;
    auto* numbers = static_cast<float*>(image.localpixels());
    for (std::size_t i = 0; i < values; ++i)
      numbers[i] = static_cast<float>(random_uniform(stream, i, -1000, 1000));
    numbers[0] = Limits::infinity(), numbers[1] = -Limits::infinity(), numbers[2] = -0.0f;
    numbers[3] = Limits::max(), numbers[4] = Limits::denorm_min(),
    numbers[5] = 65536;  // too large for a half
  }
  return image;
}

std::string refusal_to_read(const std::filesystem::path& file, DenseLabel label) {
  try {
    read_dense(file, label);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// Refused in one line, the file first, that says this.
void check_refused(const std::filesystem::path& file, DenseLabel label, const std::string& why) {
  const std::string line = refusal_to_read(file, label);
  CHECK_THAT(line, Catch::StartsWith(file.string() + ": cannot be read as the label " + to_string(label)));
  CHECK_THAT(line, Catch::Contains(why));
  CHECK(line.find('\n') == std::string::npos);
}

}  // namespace

TEST_CASE("a dense label's file gives back every bit") {
  const TemporaryFolder folder;
  for (DenseLabel label : all_labels()) {
    INFO(to_string(label));
    const OIIO::ImageBuf image = extremes_and_noise(label);
    const auto file = dense_file(folder.path / "000017.png", label);
    write_file(file, encode_dense(image, label));
    const OIIO::ImageBuf read = read_dense(file, label);
    CHECK(read.spec().format == image.spec().format);
    CHECK(read.spec().channelnames == dense_spec(label, size).channelnames);
    CHECK(read.spec().width == size.width);
    CHECK(read.spec().height == size.height);
    CHECK(same_bytes(read, image));
  }
}

TEST_CASE("other programs find the type and channels that the documentation lists") {
  const TemporaryFolder folder;
  const std::vector<std::pair<DenseLabel, std::vector<std::string>>> channels = {
      {DenseLabel::depth, {"Z"}},
      {DenseLabel::distance, {"Y"}},
      {DenseLabel::normal, {"X", "Y", "Z"}},
      {DenseLabel::rays, {"X", "Y", "Z"}},
      {DenseLabel::up, {"X", "Y"}},
      {DenseLabel::latitude, {"Y"}}};
  for (const auto& [label, names] : channels) {
    INFO(to_string(label));
    const auto file = dense_file(folder.path / "a.jpg", label);
    write_file(file, encode_dense(extremes_and_noise(label), label));
    const auto in = OIIO::ImageInput::open(file.string());
    REQUIRE(in);
    CHECK(in->spec().channelnames == names);
    CHECK(in->spec().format == OIIO::TypeDesc::FLOAT);
    CHECK(in->spec().tile_width == 0);
    CHECK(in->spec().get_string_attribute("compression") == "zip");
    // No clock and no program: the same pixels, the same bytes.
    CHECK(in->spec().get_string_attribute("DateTime") == "1970:01:01 00:00:00");
    CHECK(in->spec().get_string_attribute("Software").empty());
  }
  for (DenseLabel label : {DenseLabel::instance, DenseLabel::semantic}) {
    const std::string png = encode_dense(extremes_and_noise(label), label);
    CHECK(png.substr(1, 3) == "PNG");
    CHECK(png[24] == 16);  // bits
    CHECK(png[25] == 0);   // gray
  }
  for (DenseLabel label : all_labels())
    CHECK(encode_dense(extremes_and_noise(label), label) == encode_dense(extremes_and_noise(label), label));
}

TEST_CASE("dense labels have names of their own beside the image's") {
  CHECK(dense_file("data/front/000017.png", DenseLabel::depth) == "data/front/000017.depth.exr");
  CHECK(dense_file("000017.jpg", DenseLabel::instance) == "000017.instance.png");
  CHECK(dense_file("a.b.exr", DenseLabel::semantic) == "a.b.semantic.png");
  for (DenseLabel label : all_labels()) {
    CHECK(is_dense_file(dense_file("data.depth/000017.exr", label)));
    CHECK(is_dense_file(dense_file("a.b.png", label)));
  }
  for (const char* other : {"000017.png", "000017.exr", "data.depth/000017.exr", "depth.exr", ".depth.exr",
                            "000017.depth.png", "000017.semantic.exr", "000017.albedo.exr", "000017.depth",
                            "000017.Depth.exr", "000017.depth.exr.tmp"}) {
    INFO(other);
    CHECK_FALSE(is_dense_file(other));
  }
}

TEST_CASE("pixels that are not the label's are not encoded") {
  const auto image = [](int channels, OIIO::TypeDesc type) {
    return OIIO::ImageBuf(OIIO::ImageSpec(4, 3, channels, type));
  };
  using enum DenseLabel;
  CHECK_THROWS_WITH(encode_dense(image(3, OIIO::TypeDesc::FLOAT), depth),
                    "depth: needs pixels with Z of float, has 4 x 3 with R, G, B of float");
  CHECK_THROWS_WITH(encode_dense(image(1, OIIO::TypeDesc::HALF), depth), Catch::Contains("of half"));
  CHECK_THROWS_WITH(encode_dense(image(2, OIIO::TypeDesc::FLOAT), rays), Catch::Contains("X, Y, Z of float"));
  CHECK_THROWS_WITH(encode_dense(image(3, OIIO::TypeDesc::FLOAT), up), Catch::Contains("X, Y of float"));
  CHECK_THROWS_WITH(encode_dense(image(1, OIIO::TypeDesc::UINT8), instance), Catch::Contains("of uint16"));
  CHECK_THROWS_WITH(encode_dense(image(1, OIIO::TypeDesc::FLOAT), semantic), Catch::Contains("of uint16"));
  CHECK_THROWS_WITH(encode_dense(OIIO::ImageBuf(), depth), Catch::Contains("0 x 0"));
}

TEST_CASE("files that are not the label's are refused in one line") {
  const TemporaryFolder folder;
  const auto holding = [&](const char* name, const std::string& bytes) {
    write_file(folder.path / name, bytes);
    return folder.path / name;
  };
  using enum DenseLabel;
  const std::string depths = encode_dense(extremes_and_noise(depth), depth);
  const auto exr = holding("a.exr", depths);
  check_refused(exr, distance, "(needs Y of float, has Z of float): make the dataset again");
  check_refused(exr, rays, "needs X, Y, Z of float");
  check_refused(exr, instance, "needs Y of uint16");
  check_refused(holding("b.exr", encode_dense(extremes_and_noise(rays), rays)), up, "has X, Y, Z of float");
  check_refused(holding("c.png", encode_dense(extremes_and_noise(semantic), semantic)), latitude,
                "has Y of uint16");
  const OIIO::ImageBuf gray(OIIO::ImageSpec(4, 3, 1, OIIO::TypeDesc::UINT8));
  check_refused(holding("d.png", encode_image(gray, ImageFormat::png_gray, 0)), semantic, "has Y of uint8");
  const OIIO::ImageBuf colours(OIIO::ImageSpec(4, 3, 3, OIIO::TypeDesc::FLOAT));
  check_refused(holding("e.exr", encode_image(colours, ImageFormat::exr, 0)), normal, "has R, G, B of half");
  check_refused(holding("f.exr", depths.substr(0, depths.size() - 200)), depth, "make the dataset again");
  check_refused(holding("g.exr", "no image"), depth, "make the dataset again");
  check_refused(folder.path / "missing.exr", depth, "make the dataset again");
}
