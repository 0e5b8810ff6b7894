#include "dataset/verify/pixel_check.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <map>
#include <stdexcept>

#include "dataset/job/masters.h"
#include "dataset/pixels/image_file.h"
#include "dataset/pixels/master_file.h"
#include "files/files.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

struct ImageCheck {
  std::string fault;  ///< empty when nothing is wrong
  std::string pixels_sha256;
};

/// `frame`: the image's line of frames.csv; null: there is no hash to compare with.
ImageCheck check_image(const fs::path& file, const Label& label, const FrameRow* frame) try {
  if (frame && sha256(read_file(file)) != frame->sha256)
    return {"its bytes do not match sha256 in frames.csv", ""};
  const OIIO::ImageBuf image = read_pixels(file);
  if (image.spec().width != label.camera.width || image.spec().height != label.camera.height)
    return {"its size contradicts calibration.json", ""};
  return {"", pixels_sha256(image)};
} catch (const std::runtime_error& error) {
  return {error.what(), ""};
}

/// Empty when nothing is wrong.
std::string master_fault(const fs::path& root, const KeptMaster& master) try {
  if (sha256(read_file(root / master.file)) != master.sha256)
    return "its bytes do not match sha256 in masters.csv";
  const NoisyMaster pixels = read_master(root / master.file);
  const OIIO::ImageSpec& size = pixels.picture.spec();
  if (size.width != master.camera.width || size.height != master.camera.height)
    return "its size contradicts masters.csv";
  return "";
} catch (const std::runtime_error& error) {
  return error.what();
}

}  // namespace

void check_images(const DatasetFiles& files, Faults& faults) {
  const Dataset& dataset = files.dataset;
  std::vector<ImageCheck> checks(dataset.images.size());
  tbb::parallel_for(std::size_t{0}, checks.size(), [&](std::size_t i) {
    const DatasetImage& image = dataset.images[i];
    checks[i] =
        check_image(dataset.root / image.file, dataset.groups[image.group].label, files.frame_of(image.file));
  });
  std::map<Part, std::string> lines;
  for (std::size_t i = 0; i < checks.size(); ++i) {
    const DatasetImage& image = dataset.images[i];
    if (!checks[i].fault.empty()) faults.push_back(image.file.string() + ": " + checks[i].fault);
    lines[image.part] += image.file.string() + " " + checks[i].pixels_sha256 + "\n";
  }
  if (!files.description) return;
  const auto splits = files.description->value("splits", nlohmann::json::object());
  for (const auto& [part, text] : lines) {
    const std::string expected =
        splits.value(to_string(part), nlohmann::json::object()).value("pixels_sha256", "");
    if (sha256(text) != expected)
      faults.push_back("splits/" + to_string(part) + ".txt: pixels_sha256 in dataset.json does not match");
  }
}

std::int64_t check_masters(const DatasetFiles& files, Faults& faults) try {
  const fs::path& root = files.dataset.root;
  if (!files.description || !fs::exists(root / "masters.csv")) return 0;
  const std::vector<KeptMaster> masters = read_masters(root);
  std::vector<std::string> found(masters.size());
  tbb::parallel_for(std::size_t{0}, masters.size(),
                    [&](std::size_t i) { found[i] = master_fault(root, masters[i]); });
  for (std::size_t i = 0; i < masters.size(); ++i)
    if (!found[i].empty()) faults.push_back(masters[i].file.string() + ": " + found[i]);
  const std::int64_t views = files.description->value("views", std::int64_t{-1});
  if (views != static_cast<std::int64_t>(masters.size()))
    faults.push_back(
        fmt::format("masters.csv: lists {} masters, dataset.json {} views", masters.size(), views));
  return static_cast<std::int64_t>(masters.size());
} catch (const std::runtime_error& error) {  // masters.csv cannot be read
  faults.push_back(error.what());
  return 0;
}

}  // namespace cps
