#include "dataset/verify/verify.h"

#include <OpenImageIO/imagebuf.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <stdexcept>

#include "dataset/job/frames.h"
#include "dataset/job/image_file.h"
#include "dataset/job/master_file.h"
#include "dataset/job/masters.h"
#include "dataset/labels/label_check.h"
#include "dataset/labels/reader.h"
#include "files/files.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

struct ImageCheck {
  std::string fault;  ///< empty when nothing is wrong
  std::string pixels_sha256;
};

ImageCheck check_image(const fs::path& file, const Label& label, const std::string& expected_sha256) try {
  const std::string bytes = read_file(file);
  if (sha256(bytes) != expected_sha256) return {"its bytes do not match sha256 in frames.csv", ""};
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

bool is_image(const fs::path& file) {
  return file.extension() != ".csv" && file.extension() != ".json";
}

/// Collects faults about one dataset.
class Verifier {
 public:
  explicit Verifier(const fs::path& root)
      : dataset_(read_dataset(root)), description_(read_json(root / "dataset.json")) {}

  VerifySummary run() {
    check_labels();
    read_frames();
    check_lists();
    check_images();
    check_masters();
    check_streets();
    return summary_;
  }

 private:
  void fault(const fs::path& file, const std::string& what) {
    summary_.faults.push_back(file.string() + ": " + what);
  }

  void check_labels() {
    std::vector<LabelCheck> checks(dataset_.groups.size());
    tbb::parallel_for(std::size_t{0}, checks.size(),
                      [&](std::size_t g) { checks[g] = check_label(dataset_.groups[g].label); });
    for (std::size_t g = 0; g < checks.size(); ++g) {
      for (const std::string& what : checks[g].faults)
        fault(dataset_.groups[g].folder / "calibration.json", what);
      summary_.worst_roundtrip_px = std::max(summary_.worst_roundtrip_px, checks[g].worst_roundtrip_px);
      summary_.least_rim_margin_px = std::min(summary_.least_rim_margin_px, checks[g].rim_margin_px);
    }
    summary_.groups = static_cast<std::int64_t>(checks.size());
  }

  void read_frames() {
    for (const DatasetGroup& group : dataset_.groups) try {
        const fs::path csv = dataset_.root / group.folder / "frames.csv";
        std::set<std::string> listed;
        for (FrameRow& row : read_frames_csv(csv)) {
          listed.insert(row.file);
          frames_[(group.folder / row.file).string()] = std::move(row);
        }
        for (const fs::directory_entry& entry : fs::directory_iterator(dataset_.root / group.folder))
          if (is_image(entry.path()) && !listed.contains(entry.path().filename().string()))
            fault(group.folder / entry.path().filename(), "is not in frames.csv");
      } catch (const std::runtime_error& error) {
        summary_.faults.push_back(error.what());
      }
  }

  void check_lists() {
    std::set<std::string> seen;
    for (const DatasetImage& image : dataset_.images) {
      const Part lens_part = dataset_.groups[image.group].label.part;
      const auto frame = frames_.find(image.file.string());
      if (!seen.insert(image.file.string()).second) fault(image.file, "stands in the split lists twice");
      if (lens_part != Part::all && lens_part != image.part)
        fault(image.file,
              "is listed in " + to_string(image.part) + ", but its lens belongs to " + to_string(lens_part));
      if (frame == frames_.end())
        fault(image.file, "is not in frames.csv");
      else if (frame->second.part != to_string(image.part))
        fault(image.file,
              "is listed in " + to_string(image.part) + ", but frames.csv says " + frame->second.part);
    }
    for (const auto& [file, frame] : frames_)
      if (!seen.contains(file)) fault(file, "stands in no split list");
    const std::int64_t expected = description_.value("images", std::int64_t{-1});
    if (expected != static_cast<std::int64_t>(dataset_.images.size()))
      fault("dataset.json",
            fmt::format("images: says {}, the lists hold {}", expected, dataset_.images.size()));
  }

  void check_images() {
    std::vector<ImageCheck> checks(dataset_.images.size());
    tbb::parallel_for(std::size_t{0}, checks.size(), [&](std::size_t i) {
      const DatasetImage& image = dataset_.images[i];
      const auto frame = frames_.find(image.file.string());
      const std::string expected = frame == frames_.end() ? "" : frame->second.sha256;
      checks[i] = check_image(dataset_.root / image.file, dataset_.groups[image.group].label, expected);
    });
    std::map<Part, std::string> lines;
    for (std::size_t i = 0; i < checks.size(); ++i) {
      const DatasetImage& image = dataset_.images[i];
      if (!checks[i].fault.empty()) fault(image.file, checks[i].fault);
      lines[image.part] += image.file.string() + " " + checks[i].pixels_sha256 + "\n";
    }
    for (const auto& [part, text] : lines) {
      const auto& splits = description_.value("splits", nlohmann::json::object());
      const std::string expected =
          splits.value(to_string(part), nlohmann::json::object()).value("pixels_sha256", "");
      if (sha256(text) != expected)
        fault("splits/" + to_string(part) + ".txt", "pixels_sha256 in dataset.json does not match");
    }
    summary_.images = static_cast<std::int64_t>(checks.size());
  }

  void check_masters() {
    if (!fs::exists(dataset_.root / "masters.csv")) return;
    const std::vector<KeptMaster> masters = read_masters(dataset_.root);
    std::vector<std::string> faults(masters.size());
    tbb::parallel_for(std::size_t{0}, masters.size(),
                      [&](std::size_t i) { faults[i] = master_fault(dataset_.root, masters[i]); });
    for (std::size_t i = 0; i < masters.size(); ++i)
      if (!faults[i].empty()) fault(masters[i].file, faults[i]);
    const std::int64_t views = description_.value("views", std::int64_t{-1});
    if (views != static_cast<std::int64_t>(masters.size()))
      fault("masters.csv", fmt::format("lists {} masters, dataset.json {} views", masters.size(), views));
    summary_.masters = static_cast<std::int64_t>(masters.size());
  }

  /// What tells a scene's streets from others': those of a city are the same on all its days.
  std::string streets_of(const nlohmann::json& condition) const {
    const std::string file = condition.value("scene", "");
    for (const auto& scene : description_.value("scenes", nlohmann::json::array()))
      if (scene.value("file", "") == file && scene.contains("city"))
        return "city " + scene["city"].value("style", "") + " " +
               scene["city"].value("seed", nlohmann::json(0)).dump();
    return file;
  }

  /// No street of a scene in two parts.
  void check_streets() {
    const auto recipe = description_.value("recipe", nlohmann::json::object());
    if (recipe.value("split", "route") == "thesis") return;
    const auto conditions = description_.value("conditions", nlohmann::json::array());
    std::vector<std::string> streets;  // by condition
    for (const auto& condition : conditions) streets.push_back(streets_of(condition));
    std::map<std::pair<std::string, std::string>, std::string> part_of_street;
    for (const auto& [file, frame] : frames_) {
      const std::size_t condition = std::strtoul(frame.condition.c_str(), nullptr, 10);
      if (condition >= conditions.size()) {
        fault(file, "condition " + frame.condition + " is not in dataset.json");
        continue;
      }
      const auto [known, is_new] = part_of_street.try_emplace({streets[condition], frame.street}, frame.part);
      if (!is_new && known->second != frame.part)
        fault(file, "street " + frame.street + " occurs in " + known->second + " and " + frame.part);
    }
  }

  Dataset dataset_;
  nlohmann::json description_;
  std::map<std::string, FrameRow> frames_;  ///< by file, relative to the dataset
  VerifySummary summary_;
};

}  // namespace

std::string VerifySummary::brief() const {
  return fmt::format(
      "{} groups, {} images{}, {} faults; worst round trip {:.1e} px, master's rim at least {:.1e} px "
      "outside",
      groups, images, masters > 0 ? fmt::format(", {} masters", masters) : "", faults.size(),
      worst_roundtrip_px, least_rim_margin_px);
}

VerifySummary verify_dataset(const fs::path& root) {
  if (!fs::exists(root / "dataset.json"))
    throw std::runtime_error(root.string() +
                             ": has no dataset.json: not a dataset, or not finished; run cps generate");
  return Verifier(root).run();
}

}  // namespace cps
