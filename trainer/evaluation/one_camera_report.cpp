#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "files/plot.h"
#include "numbers/angles.h"
#include "trainer/evaluation/camera_numbers.h"
#include "trainer/evaluation/one_camera_prediction.h"

/// Table, JSON and plot of a OneCameraPrediction.
namespace cps {
namespace {

using Json = nlohmann::ordered_json;

CalibratedCamera camera_of(const ConvergencePoint& point, const ImageSize& size) {
  return to_camera(point.posterior.mean, TargetSpace::raw, size.width, size.height).value();
}

Json convergence_json(const OneCameraPrediction& p) {
  Json list = Json::array();
  for (const ConvergencePoint& point : p.convergence)
    list.push_back({{"frames", point.frames},
                    {"calibration", numbers_json(camera_of(point, p.size))},
                    {"deviation", numbers_json(point.posterior.deviation(), p.size)}});
  return list;
}

Json frames_json(const OneCameraPrediction& p) {
  Json list = Json::array();
  for (std::size_t i = 0; i < p.files.size(); ++i) {
    const FrameInCamera& frame = p.camera.frames[i];
    list.push_back({{"file", p.files[i].string()},
                    {"weight", frame.weight},
                    {"pitch_deg", degrees(frame.pitch_rad)},
                    {"roll_deg", degrees(frame.roll_rad)},
                    {"yaw_deg", degrees(frame.yaw_rad)}});
  }
  return list;
}

/// Mean and covariance in the space of the fit, row by row.
Json posterior_json(const LensPosterior& posterior) {
  Json rows = Json::array();
  for (int i = 0; i < output_count; ++i) {
    rows.push_back(Json::array());
    for (int k = 0; k < output_count; ++k) rows.back().push_back(posterior.covariance(i, k));
  }
  return {{"space", to_string(TargetSpace::seen)},
          {"names", output_names},
          {"mean", posterior.mean},
          {"covariance", rows}};
}

double doublings(const ConvergencePoint& point) {
  return std::log2(point.frames);
}

/// One number against the count of pictures, with its standard deviation to both sides and the truth.
Plot number_plot(const OneCameraPrediction& p, int output) {
  const CameraNumber& number = camera_numbers()[output];
  const std::string unit = number.unit;
  Plot plot{.title = number.name,
            .x_label = "log2 of the number of pictures",
            .y_label = number.name + (unit.empty() ? "" : ", " + unit)};
  PlotSeries value{.name = "fitted", .colour = 0}, low{.name = "± one standard deviation", .colour = 5},
      high{.colour = 5}, truth{.name = "true", .colour = 1};
  for (const ConvergencePoint& point : p.convergence) {
    const CalibratedCamera camera = camera_of(point, p.size);
    const double x = doublings(point), y = number.value(camera),
                 deviation = point.posterior.deviation()[output] * number.unit_of_raw(camera);
    value.points.emplace_back(x, y);
    low.points.emplace_back(x, y - deviation);
    high.points.emplace_back(x, y + deviation);
    if (p.truth) truth.points.emplace_back(x, number.value(*p.truth));
  }
  plot.series = {std::move(value), std::move(low), std::move(high)};
  if (p.truth) plot.series.push_back(std::move(truth));
  return plot;
}

/// Standard deviations as shares of those of one picture.
Plot deviation_plot(const OneCameraPrediction& p) {
  Plot plot{.title = "standard deviations",
            .x_label = "log2 of the number of pictures",
            .y_label = "share of one picture's"};
  for (int output : {0, 1, 6, 7}) {
    PlotSeries series{.name = camera_numbers()[output].name};
    const double first = p.convergence.front().posterior.deviation()[output];
    for (const ConvergencePoint& point : p.convergence)
      series.points.emplace_back(doublings(point), point.posterior.deviation()[output] / first);
    plot.series.push_back(std::move(series));
  }
  return plot;
}

}  // namespace

std::string report(const OneCameraPrediction& p) {
  std::string text =
      fmt::format("one camera from {} pictures ({}x{})\n  {:<10} {:>12} {:>12} {:>12}\n", p.files.size(),
                  p.size.width, p.size.height, "", "fitted", "deviation", p.truth ? "true" : "");
  for (int i = 0; i < output_count; ++i) {
    const CameraNumber& number = camera_numbers()[i];
    text += fmt::format("  {:<5} {:<4} {:12.5g} {:12.3g}", number.name, number.unit, number.value(p.fitted),
                        p.deviation[i] * number.unit_of_raw(p.fitted));
    if (p.truth) text += fmt::format(" {:12.5g}", number.value(*p.truth));
    text += "\n";
  }
  text +=
      fmt::format("  {} of {} pictures agree; edges scatter by {:.2f} of the deviations that they state\n",
                  p.camera.trusted_frames(), p.files.size(), p.camera.tilt_scatter);
  if (p.camera.certified.kept < 1)
    text += fmt::format("  not a certified lens: calibrations have {:.0f} % of its distortion\n",
                        100 * p.camera.certified.kept);
  if (p.reprojection_px) text += fmt::format("  reprojection error {:.2f} px\n", *p.reprojection_px);
  return text;
}

Json to_json(const OneCameraPrediction& p) {
  Json json{{"pictures", p.files.size()},
            {"trusted", p.camera.trusted_frames()},
            {"width", p.size.width},
            {"height", p.size.height},
            {"calibration", numbers_json(p.fitted)},
            {"deviation", numbers_json(p.deviation, p.size)},
            {"certified",
             {{"calibration", numbers_json(p.camera.certified.camera)}, {"kept", p.camera.certified.kept}}}};
  if (p.truth) json["truth"] = numbers_json(*p.truth);
  if (p.reprojection_px) json["reprojection_px"] = *p.reprojection_px;
  json["tilt_scatter"] = p.camera.tilt_scatter;
  json["posterior"] = posterior_json(p.camera.posterior);
  json["convergence"] = convergence_json(p);
  json["frames"] = frames_json(p);
  return json;
}

std::string convergence_svg(const OneCameraPrediction& p) {
  return to_svg(std::vector{number_plot(p, 0), number_plot(p, 1), deviation_plot(p)}, 3);
}

}  // namespace cps
