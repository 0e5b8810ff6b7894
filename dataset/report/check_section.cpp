#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dataset/report/sections.h"
#include "dataset/report/text.h"
#include "dataset/verify/kept_results.h"
#include "files/html_page.h"
#include "files/markup.h"

namespace cps {
namespace {

constexpr std::size_t max_faults = 50, max_rerendered = 100, max_text = 400;

std::string verdict(bool is_good, const std::string& text) {
  return fmt::format("<p class=\"{}\">{}</p>\n", is_good ? "good" : "bad", escaped(text));
}

std::string verification(const std::filesystem::path& root) {
  const auto kept = kept_verification(root);
  if (!kept) return "<p>Not verified. <code>cps verify</code> checks every file against its label.</p>\n";
  std::string html;
  if (kept->dataset_sha256 != description_sha256(root))
    html += verdict(false, "dataset.json has changed since it was verified; run cps verify again.");
  html += verdict(kept->faults == 0, kept->faults == 0 ? "Verified: no faults."
                                                       : "Faults found: " + grouped(kept->faults) + ".");
  html += html_table(
      {"", ""},
      {{"checked by", clipped(kept->generator, 200)},
       {"groups, images, masters",
        grouped(kept->groups) + ", " + grouped(kept->images) + ", " + grouped(kept->masters)},
       {"worst round trip of a pixel through its lens", fmt::format("{:.1e} px", kept->max_roundtrip_px)},
       {"rim of a master from the image, at least", fmt::format("{:.1e} px", kept->min_rim_margin_px)},
       {"labels and poses", kept->is_planned_again ? "compared with the recipe's plan, made again"
                                                   : "not compared with the recipe's plan"}});
  if (kept->faults > 0) {
    html += "<ul>\n";
    for (std::size_t i = 0; i < std::min(max_faults, kept->first_faults.size()); ++i)
      html += "<li>" + clipped(kept->first_faults[i], max_text) + "\n";
    html += "</ul>\n";
  }
  return html;
}

std::string rerendering(const std::filesystem::path& root) {
  const auto kept = kept_rerender(root);
  if (!kept)
    return "<p>No images were rendered again. <code>cps verify --rerender 20</code> renders twenty through "
           "the lens of their label.</p>\n";
  const auto faults =
      std::ranges::count_if(kept->images, [](const auto& image) { return !image.fault.empty(); });
  std::vector<std::vector<std::string>> rows;
  for (const RerenderedImage& image : kept->images) {
    if (rows.size() == max_rerendered) break;
    const Registration& found = image.registration;
    rows.push_back(
        {clipped(image.file, 200),
         fmt::format("{:.3f} ± {:.3f}", std::hypot(found.shift_x_px, found.shift_y_px), found.shift_noise_px),
         fmt::format("{:.3f}", found.block_rms_px), fmt::format("{:.3f}", found.worst_block_px),
         fmt::format("{:.1f}", found.psnr_db), fmt::format("{:.3f}", found.correlation),
         image.fault.empty() ? "agrees" : clipped(image.fault, max_text)});
  }
  const auto images = std::ssize(kept->images);
  std::string html = verdict(
      faults == 0,
      fmt::format("{} of {} images rendered again at {} samples per pixel agree with their labels and poses.",
                  images - faults, images, kept->samples));
  html += fmt::format("<p>Allowed: {:g} px of shift beyond its noise, {:g} px rms of the blocks.</p>\n",
                      kept->max_shift_px, kept->max_block_rms_px);
  return html +
         html_table({"image", "shift, px", "blocks, px rms", "worst block, px", "dB", "correlation", ""},
                    rows);
}

}  // namespace

std::string check_section(const std::filesystem::path& root) {
  return "<section id=\"checks\"><h2>Checks</h2>\n" + verification(root) + "<h3>Rendered again</h3>\n" +
         rerendering(root) + "</section>\n";
}

}  // namespace cps
