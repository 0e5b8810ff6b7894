#include <OpenImageIO/imagebuf.h>

#include <algorithm>
#include <cstdio>

#include "files/plot.h"
#include "files/png.h"
#include "numbers/angles.h"
#include "trainer/evaluation/evaluate.h"

namespace cps {
namespace {

std::string escaped(const std::string& text) {
  std::string html;
  for (char c : text) html += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
  return html;
}

std::string base64(const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned triple = 0;
    for (std::size_t k = 0; k < 3; ++k)
      triple = triple << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    for (int k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[triple >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

PlotSeries diagonal(Interval range) {
  return {.style = PlotStyle::line, .points = {{range.low, range.low}, {range.high, range.high}}};
}

/// What was said against what is true, of one output, coefficients in apparent space.
Plot predicted_against_true(const Evaluation& e, int output) {
  Plot plot{.title = output == 0 ? "H-FOV, degrees"
                                 : std::string(output_names[output]) + (output < 6 ? ", scaled" : ""),
            .x_label = "true",
            .y_label = "predicted"};
  PlotSeries dots{.style = PlotStyle::dots};
  Interval range{INFINITY, -INFINITY};
  for (const EvaluatedImage& image : e.images) {
    const double unit = output == 0 ? degrees(1) : 1;
    const double truth = unit * to_outputs(image.image.truth, TargetSpace::apparent)[output],
                 said = truth + unit * image.network.apparent[output];
    dots.points.emplace_back(truth, said);
    range = {std::min({range.low, truth, said}), std::max({range.high, truth, said})};
  }
  plot.series = {std::move(dots), diagonal(range)};
  return plot;
}

Plot error_against_hfov(const Evaluation& e, const char* title, const char* label,
                        std::optional<double> (*error)(const ImageErrors&)) {
  Plot plot{.title = title, .x_label = "true H-FOV, degrees", .y_label = label};
  PlotSeries network{.name = "network", .style = PlotStyle::dots},
      mean{.name = "train mean", .style = PlotStyle::dots};
  for (const EvaluatedImage& image : e.images) {
    const double hfov_deg = degrees(hfov_rad(image.image.truth.camera));
    if (const auto value = error(image.network)) network.points.emplace_back(hfov_deg, *value);
    if (const auto value = error(image.training_mean)) mean.points.emplace_back(hfov_deg, *value);
  }
  plot.series = {std::move(network), std::move(mean)};
  return plot;
}

std::string plots(const Evaluation& e) {
  std::vector<Plot> all;
  for (int output = 0; output < output_count; ++output) all.push_back(predicted_against_true(e, output));
  all.push_back(error_against_hfov(e, "H-FOV error", "degrees",
                                   [](const ImageErrors& i) { return std::optional(i.hfov_deg); }));
  all.push_back(error_against_hfov(e, "reprojection error", "pixels",
                                   [](const ImageErrors& i) { return i.reprojection_px; }));
  return to_svg(all, 3);
}

/// The image, at most 420 pixels wide, as a data URI; empty when it can no longer be read.
std::string picture(const EvaluatedImage& image) {
  try {
    const GrayImage whole = read_gray_image(image.image.file);
    const GrayImage gray = area_average(whole, reduced_size(whole.size, {.width = 420}));
    OIIO::ImageBuf pixels(OIIO::ImageSpec(gray.size.width, gray.size.height, 1, OIIO::TypeDesc::UINT8));
    pixels.set_pixels(OIIO::ROI::All(), OIIO::TypeDesc::UINT8, gray.pixels.data());
    return "data:image/png;base64," + base64(encode_png(pixels));
  } catch (const std::exception&) {
    return "";
  }
}

std::string worst_images(const Evaluation& e) {
  constexpr std::size_t shown = 12;
  std::vector<const EvaluatedImage*> images;
  for (const EvaluatedImage& image : e.images) images.push_back(&image);
  std::ranges::stable_sort(images, [](const EvaluatedImage* a, const EvaluatedImage* b) {
    return a->network.reprojection_px.value_or(INFINITY) > b->network.reprojection_px.value_or(INFINITY);
  });
  std::string html;
  for (std::size_t i = 0; i < std::min(shown, images.size()); ++i) {
    const EvaluatedImage& image = *images[i];
    char numbers[200];
    const double truth = degrees(hfov_rad(image.image.truth.camera));
    std::snprintf(numbers, sizeof numbers, "reprojection %.1f px; H-FOV %.1f deg, said %.1f deg",
                  image.network.reprojection_px.value_or(INFINITY), truth, degrees(image.said[0]));
    html += "<figure><img src=\"" + picture(image) + "\" alt=\"\"><figcaption>" + escaped(image.image.name) +
            "<br>" + numbers + "</figcaption></figure>\n";
  }
  return html;
}

}  // namespace

std::string to_html(const Evaluation& evaluation) {
  return "<!doctype html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>cps eval: " +
         escaped(evaluation.set) +
         "</title>\n<style>body{font:15px sans-serif;max-width:1300px;margin:2em auto;padding:0 1em}"
         "figure{display:inline-block;margin:.5em;vertical-align:top}img{max-width:420px}"
         "figcaption{font-size:12px;max-width:420px;overflow-wrap:anywhere}svg{max-width:100%;height:auto}"
         "pre{overflow-x:auto}</style>\n<h1>" +
         escaped(evaluation.set) + "</h1>\n<pre>" + escaped(evaluation.report()) +
         "</pre>\n<h2>Predicted against true, and errors against H-FOV</h2>\n" + plots(evaluation) +
         "<h2>Worst images</h2>\n" + worst_images(evaluation) + "</html>\n";
}

}  // namespace cps
