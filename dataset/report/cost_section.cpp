#include <fmt/format.h>

#include <set>

#include "dataset/job/journal.h"
#include "dataset/job/ledger.h"
#include "dataset/report/sections.h"
#include "dataset/report/text.h"
#include "files/html_page.h"

namespace cps {
namespace {

constexpr std::size_t max_runs = 200, max_journals = 200;

std::string hours(double seconds) {
  if (seconds < 120) return fmt::format("{:.1f} s", seconds);
  if (seconds < 7200) return fmt::format("{:.1f} min", seconds / 60);
  return fmt::format("{:.2f} h", seconds / 3600);
}

std::string stages(const RunTimes& sum) {
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const char* stage, double seconds) {
    const double share = sum.cpu_s > 0 ? 100 * seconds / sum.cpu_s : 0;
    rows.push_back({stage, hours(seconds), fmt::format("{:.1f} %", share)});
  };
  add("render", sum.cpu.render_s);
  if (sum.cpu.labels_s > 0) add("dense labels", sum.cpu.labels_s);
  add("warp", sum.cpu.warp_s);
  add("develop", sum.cpu.develop_s);
  add("encode", sum.cpu.encode_s);
  add("write", sum.cpu.write_s);
  add("scenes and the rest", sum.cpu_s - sum.cpu.sum_s());
  return html_table({"stage", "CPU time", "share"}, rows);
}

std::string ledger(const std::filesystem::path& root) {
  const std::vector<LedgerEntry> entries = read_ledger(root);
  if (entries.empty()) return "<p>No times were kept for this dataset.</p>\n";
  RunTimes sum;
  std::vector<std::vector<std::string>> rows;
  for (const auto& [shard, times] : entries) {
    sum.views += times.views;
    sum.images += times.images;
    sum.cpu_s += times.cpu_s;
    sum.wall_s += times.wall_s;
    sum.cpu.render_s += times.cpu.render_s;
    sum.cpu.labels_s += times.cpu.labels_s;
    sum.cpu.warp_s += times.cpu.warp_s;
    sum.cpu.develop_s += times.cpu.develop_s;
    sum.cpu.encode_s += times.cpu.encode_s;
    sum.cpu.write_s += times.cpu.write_s;
    if (rows.size() < max_runs)
      rows.push_back({to_string(shard), grouped(times.views), grouped(times.images),
                      std::to_string(times.threads), hours(times.wall_s), hours(times.cpu_s),
                      times.is_interrupted ? "interrupted" : ""});
  }
  std::string html = fmt::format(
      "<p>{} of CPU time ({} on the clock, one run after the other) for {} images: {:.3g} images per "
      "core-hour. Runs: {}; any that ended with an error are not counted.</p>\n",
      hours(sum.cpu_s), hours(sum.wall_s), grouped(sum.images),
      sum.cpu_s > 0 ? 3600 * static_cast<double>(sum.images) / sum.cpu_s : 0.0, entries.size());
  html += stages(sum) + "<h3>Runs</h3>\n";
  if (entries.size() > max_runs)
    html += fmt::format("<p>The first {} of {}.</p>\n", max_runs, entries.size());
  return html + html_table({"shard", "views", "images", "threads", "time", "CPU time", ""}, rows);
}

std::string journals(const std::filesystem::path& root) {
  const std::vector<JournalTally> tallies = tally_journals(root);
  if (tallies.empty()) return "";
  double bytes = 0;
  std::int64_t images = 0;
  std::vector<std::vector<std::string>> rows;
  for (const JournalTally& tally : tallies) {
    bytes += static_cast<double>(tally.bytes);
    images += tally.images;
    if (rows.size() < max_journals)
      rows.push_back({to_string(tally.shard), grouped(tally.views), grouped(tally.images),
                      bytes_text(static_cast<double>(tally.bytes)), grouped(tally.unreadable)});
  }
  std::string html =
      fmt::format("<h3>Journals</h3>\n<p>{} images of {}, {} on average.</p>\n", grouped(images),
                  bytes_text(bytes), bytes_text(images > 0 ? bytes / static_cast<double>(images) : 0));
  if (tallies.size() > max_journals)
    html += fmt::format("<p>The first {} of {}.</p>\n", max_journals, tallies.size());
  return html + html_table({"shard", "views", "images", "on disk", "damaged lines"}, rows);
}

}  // namespace

std::string cost_section(const std::filesystem::path& root) {
  return "<section id=\"costs\"><h2>Times and costs</h2>\n" + ledger(root) + journals(root) + "</section>\n";
}

}  // namespace cps
