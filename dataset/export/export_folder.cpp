#include "dataset/export/export_folder.h"

#include <algorithm>
#include <stdexcept>

#include "dataset/dense/dense_file.h"
#include "dataset/job/job.h"
#include "dataset/labels/group_label.h"
#include "files/files.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// What decides the export's bytes.
std::string request_text(const ExportSource& source, const ExportOptions& options) {
  nlohmann::ordered_json json = {{"format", to_string(options.target)}, {"generator", generator_name()}};
  if (options.target == ExportTarget::webdataset) json["shard_mb"] = options.shard_mb;
  for (const auto& [key, value] : options.publication())
    if (!value->empty()) json[key] = *value;
  json["dataset"] = source.name;
  json["dataset_sha256"] = source.sha256;
  for (Part part : {Part::train, Part::val, Part::test})
    json["images"][to_string(part)] = source.images_of(part).size();
  return json.dump(2) + "\n";
}

/// `key: <there>, not <wanted>` for the first key that differs.
std::string first_difference(const nlohmann::json& there, const nlohmann::json& wanted) {
  nlohmann::json all = there;
  all.update(wanted);
  for (const auto& [key, value] : all.items())
    if (const nlohmann::json a = there.value(key, nlohmann::json()), b = wanted.value(key, nlohmann::json());
        a != b)
      return key + ": " + a.dump() + ", not " + b.dump();
  return "other text";
}

/// Whether `inner` is `outer` or lies below it.
bool lies_in(const fs::path& inner, const fs::path& outer) {
  const fs::path relative = fs::weakly_canonical(inner).lexically_relative(fs::canonical(outer));
  return !relative.empty() && *relative.begin() != "..";
}

void require_place(const fs::path& out, const fs::path& dataset) {
  if (lies_in(out, dataset))
    throw std::runtime_error(out.string() + ": lies in the dataset itself: name a folder elsewhere");
  if (!fs::exists(out)) return;
  if (!fs::is_directory(out)) throw std::runtime_error(out.string() + ": is a file: name a folder");
  const bool is_ours = fs::exists(out / "export.json") || fs::exists(out / ".cps" / "export.json");
  const auto is_other = [](const fs::directory_entry& entry) { return entry.path().filename() != ".cps"; };
  if (!is_ours && std::any_of(fs::directory_iterator(out), fs::directory_iterator(), is_other))
    throw std::runtime_error(out.string() + ": holds other things: name a new or empty folder");
  if (has_job(out)) throw std::runtime_error(out.string() + ": holds a dataset: name a new or empty folder");
}

void require_same(const fs::path& file, const std::string& request) {
  if (read_file(file) == request) return;
  const nlohmann::json there = read_json(file);
  if (!there.is_object()) throw std::runtime_error(file.string() + ": is of no export: name another folder");
  throw std::runtime_error(file.string() + ": is of another export (" +
                           first_difference(there, nlohmann::json::parse(request)) +
                           "): name another folder, or remove that one");
}

void remove_all_temporaries(const fs::path& folder) {
  remove_temporaries(folder);
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_directory()) remove_temporaries(entry.path());
}

}  // namespace

ExportFolder::ExportFolder(const fs::path& out, const ExportSource& source, const ExportOptions& options)
    : out_(out), request_(request_text(source, options)), copy_(options.copy) {
  require_place(out, source.dataset().root);
  if (fs::exists(out / "export.json")) {
    require_same(out / "export.json", request_);
    is_finished_ = true;
    fs::remove_all(out / ".cps");
    return;
  }
  lock_.emplace(out / ".cps" / "lock", FileLock::Kind::exclusive);
  if (!lock_->is_held())
    throw HeldByAnother(out.string() + ": another process exports to it; run it again when that is done");
  if (const fs::path begun = out / ".cps" / "export.json"; fs::exists(begun))
    require_same(begun, request_);
  else
    write_file(begun, request_);
  remove_all_temporaries(out);
}

void ExportFolder::add_image(const ExportSource& source, const DatasetImage& image, const fs::path& name) {
  add(source.dataset().root / image.file, name, [&] { return read_image(source, image); });
}

void ExportFolder::add_dense(const ExportSource& source, const DatasetImage& image, DenseLabel label,
                             const fs::path& name) {
  add(source.dataset().root / dense_file(image.file, label), name,
      [&] { return read_dense_bytes(source, image, label); });
}

void ExportFolder::add(const fs::path& from, const fs::path& name, const std::function<std::string()>& read) {
  const fs::path to = out_ / name;
  std::error_code failed;
  const std::uintmax_t bytes = fs::file_size(from, failed);
  if (failed) throw std::runtime_error(from.string() + ": cannot be read: " + failed.message());
  if (fs::exists(to) && fs::file_size(to) == bytes) return;
  if (!copy_) {
    fs::create_directories(to.parent_path(), failed);
    fs::remove(to, failed);
    fs::create_hard_link(from, to, failed);
    if (!failed) return;
  }
  write_file(to, read());
}

ExportedFile ExportFolder::write(const std::string& name,
                                 const std::function<void(const Append&)>& produce) const {
  ExportedFile file{.name = name};
  Sha256 hash;
  write_in_pieces(out_ / name, [&](const Append& append) {
    produce([&](std::span<const char> bytes) {
      append(bytes);
      hash.add(bytes);
      file.bytes += bytes.size();
    });
  });
  file.sha256 = hash.hex();
  return file;
}

fs::path ExportFolder::record_of(const std::string& name) const {
  return out_ / ".cps" / (name + ".json");
}

std::optional<ExportedFile> ExportFolder::kept(const std::string& name) const try {
  if (!fs::exists(record_of(name)) || !fs::exists(out_ / name)) return {};
  const nlohmann::json json = read_json(record_of(name));
  const ExportedFile file{name, json.at("samples"), json.at("bytes"), json.at("sha256")};
  if (file.samples < 1 || fs::file_size(out_ / name) != file.bytes ||
      sha256_of_file(out_ / name) != file.sha256)
    return {};
  return file;
} catch (const std::exception&) {
  return {};  // a damaged record is as good as none: the file is written again
}

void ExportFolder::record(const ExportedFile& file) {
  write_json(record_of(file.name),
             {{"samples", file.samples}, {"bytes", file.bytes}, {"sha256", file.sha256}});
}

void ExportFolder::finish() {
  write_file(out_ / "export.json", request_);
  lock_.reset();
  fs::remove_all(out_ / ".cps");
}

}  // namespace cps
