#include <fmt/format.h>

#include <vector>

#include "dataset/dense/dense_file.h"
#include "dataset/export/sample_columns.h"
#include "dataset/export/scene_classes.h"
#include "dataset/export/tar.h"
#include "dataset/export/targets.h"
#include "files/files.h"

/// WebDataset: tars <part>-<number>.tar, in which the files of one sample stand one after the other and share
/// their name up to the first point: the image, its dense labels, its label; and <part>-index.json, a shard
/// list as its `wids` reads it.
namespace cps {
namespace {

namespace fs = std::filesystem;

/// The number of the image in its part's list, so that names sort in the order of the list.
std::string sample_name(std::size_t index) {
  return fmt::format("{:09}", index);
}

/// `000000017.depth.exr`
std::string dense_name(const std::string& sample, const DatasetImage& image, DenseLabel label) {
  return sample + "." + to_string(label) + dense_file(image.file, label).extension().string();
}

std::uint64_t size_in_tar_of(const ExportJob& job, const fs::path& file) {
  std::error_code failed;
  const std::uintmax_t size = fs::file_size(job.source.dataset().root / file, failed);
  if (failed) throw std::runtime_error(file.string() + ": cannot be read: " + failed.message());
  return size_in_tar(size);
}

std::uint64_t size_in_tar_of(const ExportJob& job, const DatasetImage& image) {
  std::uint64_t bytes =
      size_in_tar_of(job, image.file) + size_in_tar(sample_json(job.source, image).dump().size());
  for (DenseLabel label : job.source.dense_labels)
    bytes += size_in_tar_of(job, dense_file(image.file, label));
  return bytes;
}

/// How many images from the first one on fit into a tar of that size; at least one.
std::size_t count_that_fit(const ExportJob& job, std::span<const DatasetImage> images) {
  const std::uint64_t most = static_cast<std::uint64_t>(job.options.shard_mb) * 1'000'000;
  std::uint64_t bytes = tar_end_bytes;
  std::size_t count = 0;
  for (; count < images.size(); ++count) {
    bytes += size_in_tar_of(job, images[count]);
    if (bytes > most && count > 0) break;
  }
  return count;
}

ExportedFile write_shard(const ExportJob& job, const std::string& name, std::size_t first,
                         std::span<const DatasetImage> images) {
  ExportedFile shard = job.folder.write(name, [&](const Append& append) {
    for (std::size_t i = 0; i < images.size(); ++i) {
      const std::string sample = sample_name(first + i);
      add_to_tar(append, sample + images[i].file.extension().string(), read_image(job.source, images[i]));
      for (DenseLabel label : job.source.dense_labels)
        add_to_tar(append, dense_name(sample, images[i], label),
                   read_dense_bytes(job.source, images[i], label));
      add_to_tar(append, sample + ".json", sample_json(job.source, images[i]).dump());
    }
    end_tar(append);
  });
  shard.samples = static_cast<std::int64_t>(images.size());
  return shard;
}

void write_index(const ExportJob& job, const std::string& part, const std::vector<ExportedFile>& shards) {
  nlohmann::ordered_json index = {{"__kind__", "wids-shard-index-v1"},
                                  {"wids_version", 1},
                                  {"name", job.source.name + " " + part},
                                  {"shardlist", nlohmann::ordered_json::array()}};
  for (const ExportedFile& shard : shards)
    index["shardlist"].push_back({{"url", shard.name},
                                  {"nsamples", shard.samples},
                                  {"filesize", shard.bytes},
                                  {"sha256", shard.sha256}});
  write_json(job.folder.at(part + "-index.json"), index);
}

}  // namespace

void export_webdataset(const ExportJob& job) {
  if (job.source.has(DenseLabel::semantic))
    write_json(job.folder.at("classes.json"), scene_classes(job.source));
  for (Part part : {Part::train, Part::val, Part::test}) {
    const std::span<const DatasetImage> images = job.source.images_of(part);
    std::vector<ExportedFile> shards;
    for (std::size_t first = 0; first < images.size();) {
      const std::string name = fmt::format("{}-{:06}.tar", to_string(part), shards.size());
      std::optional<ExportedFile> shard = job.folder.kept(name);
      if (!shard) {
        const std::span<const DatasetImage> rest = images.subspan(first);
        shard = write_shard(job, name, first, rest.first(count_that_fit(job, rest)));
        job.folder.record(*shard);
      }
      shards.push_back(*shard);
      first += static_cast<std::size_t>(shard->samples);
      job.progress(shard->samples, name);
    }
    write_index(job, to_string(part), shards);
  }
}

}  // namespace cps
