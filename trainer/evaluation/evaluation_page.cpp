#include <OpenImageIO/imagebuf.h>
#include <fmt/format.h>

#include <algorithm>

#include "files/data_uri.h"
#include "files/html_page.h"
#include "files/markup.h"
#include "files/plot.h"
#include "files/png.h"
#include "numbers/angles.h"
#include "trainer/evaluation/evaluate.h"

namespace cps {
namespace {

PlotSeries diagonal(Interval range) {
  return {.style = PlotStyle::line, .points = {{range.low, range.low}, {range.high, range.high}}};
}

/// Predicted against true values of one output, coefficients in apparent space.
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
                 predicted = truth + unit * image.network.apparent[output];
    dots.points.emplace_back(truth, predicted);
    range = {std::min({range.low, truth, predicted}), std::max({range.high, truth, predicted})};
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
    const double hfov_deg = degrees(hfov_rad(image.image.truth.pinhole));
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

/// The image, at most 420 pixels wide, as a data URI; empty if it can no longer be read.
std::string picture(const EvaluatedImage& image) {
  try {
    const GrayImage whole = read_gray_image(image.image.file);
    const GrayImage gray = area_average(whole, reduced_size(whole.size, {.width = 420}));
    OIIO::ImageBuf pixels(OIIO::ImageSpec(gray.size.width, gray.size.height, 1, OIIO::TypeDesc::UINT8));
    pixels.set_pixels(OIIO::ROI::All(), OIIO::TypeDesc::UINT8, gray.pixels.data());
    return data_uri("image/png", encode_png(pixels));
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
    html += fmt::format(
        R"(<figure><img src="{}" alt=""><figcaption>{}<br>reprojection {:.1f} px; H-FOV {:.1f} deg, predicted {:.1f} deg</figcaption></figure>
)",
        picture(image), escaped(image.image.name), image.network.reprojection_px.value_or(INFINITY),
        degrees(hfov_rad(image.image.truth.pinhole)), degrees(image.predicted[0]));
  }
  return html;
}

}  // namespace

std::string to_html(const Evaluation& evaluation) {
  return html_page("cps eval: " + evaluation.set,
                   fmt::format(R"(<h1>{}</h1>
<pre>{}</pre>
<h2>Predicted against true, and errors against H-FOV</h2>
{}<h2>Worst images</h2>
{})",
                               escaped(evaluation.set), escaped(evaluation.report()), plots(evaluation),
                               worst_images(evaluation)));
}

}  // namespace cps
