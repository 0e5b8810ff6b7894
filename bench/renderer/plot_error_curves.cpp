#include <cmath>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <stdexcept>

#include "files/files.h"
#include "files/plot.h"

/// Error against samples, from the CSVs of `cps render --reference`, as SVG:
///
///     plot_error_curves OUT.svg NAME=FILE.csv …

namespace cps {
namespace {

/// The first column, `samples`, and the root of the fourth, `rel_mse`, as decimal logarithms.
PlotSeries read_curve(const std::string& argument) {
  const std::size_t equals = argument.find('=');
  if (equals == std::string::npos) throw std::runtime_error(argument + ": must be NAME=FILE.csv");
  PlotSeries curve{.name = argument.substr(0, equals)};
  std::istringstream lines(read_file(argument.substr(equals + 1)));
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    double samples, cpu_s, rmse, rel_mse;
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &samples, &cpu_s, &rmse, &rel_mse) != 4)
      throw std::runtime_error(argument + ": a line is not samples,cpu_s,rmse,rel_mse,…: " + line);
    curve.points.push_back({std::log10(samples), 0.5 * std::log10(rel_mse)});
  }
  return curve;
}

/// Error of independent samples: falls with the root of their number.
PlotSeries root_law(const PlotSeries& from) {
  PlotSeries law{.name = "1/√samples"};
  for (const Eigen::Vector2d& point : from.points)
    law.points.push_back({point.x(), from.points[0].y() - 0.5 * (point.x() - from.points[0].x())});
  return law;
}

void plot(int count, char** arguments) {
  if (count < 3) throw std::runtime_error("plot_error_curves OUT.svg NAME=FILE.csv …");
  Plot diagram{.title = "Error of a street's picture",
               .x_label = "log10 samples a pixel",
               .y_label = "log10 relative RMSE"};
  for (int i = 2; i < count; ++i) diagram.series.push_back(read_curve(arguments[i]));
  diagram.series.push_back(root_law(diagram.series.front()));
  write_file(arguments[1], to_svg(std::span(&diagram, 1), 1));
}

}  // namespace
}  // namespace cps

int main(int count, char** arguments) try {
  cps::plot(count, arguments);
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
