#include <sys/resource.h>

#include "apps/pictures/picture_file.h"
#include "apps/pictures/picture_format.h"
#include "files/files.h"
#include "tests/apps/pictures/pictures.h"
#include "tests/fuzz/mutate_bytes.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

constexpr int mutant_width = 24, mutant_height = 16;

struct Sample {
  std::string extension;
  std::vector<unsigned char> bytes;
};

/// A picture of every format and pixel type that is written.
std::vector<Sample> picture_samples(const fs::path& folder) {
  std::vector<Sample> samples;
  for (const PictureFormat& format : picture_formats())
    for (const OIIO::TypeDesc& type : format.types) {
      const std::string extension = format.extensions.front();
      Picture picture{.pixels = {},
                      .file = OIIO::ImageSpec(mutant_width, mutant_height, 3, type),
                      .is_light = true,
                      .is_srgb = true};
      picture.pixels.reset(OIIO::ImageSpec(mutant_width, mutant_height, 3, OIIO::TypeFloat));
      for (int y = 0; y < mutant_height; ++y)
        for (int x = 0; x < mutant_width; ++x) {
          const float pixel[] = {static_cast<float>(noise(x, y, 0)), static_cast<float>(noise(x, y, 1)),
                                 0.5f};
          picture.pixels.setpixel(x, y, pixel);
        }
      const fs::path file = folder / ("sample" + extension);
      try {
        write_picture(file, picture.pixels, picture);
      } catch (const std::runtime_error&) {
        continue;  // a format of one channel
      }
      const std::string bytes = read_file(file);
      samples.push_back({extension, {bytes.begin(), bytes.end()}});
      fs::remove(file);
    }
  return samples;
}

/// Mutated files, most of them in their first bytes, where sizes and types are.
void read_mutations(std::uint64_t seed, int count) {
  const TemporaryFolder folder;
  const std::vector<Sample> samples = picture_samples(folder.path);
  REQUIRE(samples.size() > 8);
  constexpr std::size_t header_bytes = 256;
  int read = 0, refused = 0;
  for (int i = 0; i < count; ++i) {
    const Stream stream = substream(make_stream(seed, "picture mutations"), i);
    const auto& [extension, original] = samples[i % samples.size()];
    const bool is_header = random_below(stream, 1000, 4) != 0;
    const std::size_t head = is_header ? std::min(header_bytes, original.size()) : original.size();
    std::vector<unsigned char> bytes =
        mutate_bytes({original.begin(), original.begin() + static_cast<std::ptrdiff_t>(head)}, stream);
    bytes.insert(bytes.end(), original.begin() + static_cast<std::ptrdiff_t>(head), original.end());
    const fs::path file = folder.path / ("mutated" + extension);
    write_file(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    INFO("mutation " << i << ", " << extension);
    try {
      const Picture picture =
          read_picture(file, Encoding::automatic, Resampling::footprint, mutant_width, mutant_height);
      REQUIRE(picture.pixels.spec().width == mutant_width);
      REQUIRE(picture.pixels.spec().height == mutant_height);
      ++read;
    } catch (const std::runtime_error& error) {
      const std::string line = error.what();
      REQUIRE_THAT(line, Catch::StartsWith(file.string() + ": "));
      REQUIRE(line.find('\n') == line.npos);
      ++refused;
    }
    fs::remove(file);
  }
  CHECK(read > count / 20);
  CHECK(refused > count / 20);
}

}  // namespace

TEST_CASE("mutated pictures are read in their size or refused in one line") {
  read_mutations(1, 1500);
}

// OpenImageIO 2.4 ends the program on such a file: found by the case below.
TEST_CASE("a DPX that announces more user data than it holds is refused") {
  const TemporaryFolder folder;
  for (const Sample& sample : picture_samples(folder.path)) {
    if (sample.extension != ".dpx") continue;
    std::string bytes(sample.bytes.begin(), sample.bytes.end());
    bytes[32] = bytes[35] = '\x80';  // whichever of the two byte orders it has
    const fs::path file = folder.path / "user_data.dpx";
    write_file(file, bytes);
    CHECK_THROWS_WITH(
        read_picture(file, Encoding::automatic, Resampling::footprint, mutant_width, mutant_height),
        Catch::Contains("user_data.dpx: is damaged") && Catch::Contains("of user data"));
  }
}

TEST_CASE("a minute of mutated pictures", "[slow]") {
  read_mutations(2, 30'000);
}
