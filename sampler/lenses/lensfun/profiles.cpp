#include "sampler/lenses/lensfun/profiles.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <pugixml.hpp>
#include <stdexcept>
#include <string>

#include "distortion/certificate/frame_certificate.h"
#include "numbers/angles.h"

namespace cps {
namespace {

namespace fs = std::filesystem;

/// "4:3" or "1.333"; 3:2 where there is none.
double aspect_ratio(const std::string& text) {
  if (text.empty()) return 1.5;
  const std::size_t colon = text.find(':');
  return colon == text.npos ? std::stod(text) : std::stod(text) / std::stod(text.substr(colon + 1));
}

LensfunProfile read_profile(const pugi::xml_node& lens, const pugi::xml_node& row) {
  LensfunProfile profile;
  profile.aspect = aspect_ratio(lens.child_value("aspect-ratio"));
  const double full_frame_diagonal_mm = std::hypot(36, 24);
  const double diagonal_mm = full_frame_diagonal_mm / lens.child("cropfactor").text().as_double(1);
  const double width_mm = diagonal_mm * profile.aspect / std::hypot(1, profile.aspect);
  const double focal_mm = row.attribute(row.attribute("real-focal") ? "real-focal" : "focal").as_double();
  profile.hfov_deg = degrees(2 * std::atan(0.5 * width_mm / focal_mm));
  const auto number = [&](const char* key) { return row.attribute(key).as_double(); };
  const std::string model = row.attribute("model").value();
  if (model == "ptlens")
    profile.polynomial = {1 - number("a") - number("b") - number("c"), number("c"), number("b"), number("a"),
                          0};
  else if (model == "poly3")
    profile.polynomial = {1 - number("k1"), 0, number("k1"), 0, 0};
  else if (model == "poly5")
    profile.polynomial = {1, 0, number("k1"), 0, number("k2")};
  else
    throw std::runtime_error("distortion model \"" + model + "\" is not known");
  return profile;
}

/// The radius at which the profile shows an undistorted radius, both in half short sides, without the
/// paraxial scale.
double seen_at(const LensfunProfile& profile, double radius) {
  const auto& p = profile.polynomial;
  const double u = radius / p[0];
  return radius * (1 + u * (p[1] + u * (p[2] + u * (p[3] + u * p[4]))) / p[0]);
}

/// The undistorted radius that is seen in the frame's corner; empty if the profile folds before it.
std::optional<double> corner_radius(const LensfunProfile& profile) {
  const double corner = std::hypot(1, profile.aspect), step = corner / 512;
  double radius = 0;
  while (seen_at(profile, radius + step) < corner) {
    if (seen_at(profile, radius + step) <= seen_at(profile, radius)) return std::nullopt;
    radius += step;
  }
  double beyond = radius + step;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (radius + beyond);
    (seen_at(profile, middle) < corner ? radius : beyond) = middle;
  }
  return radius;
}

}  // namespace

std::vector<LensfunProfile> read_lensfun(const fs::path& folder) {
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const auto& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".xml") files.push_back(entry.path());
  if (files.empty())
    throw std::runtime_error(folder.string() + ": holds no .xml; name the folder of liblensfun-data-v1");
  std::sort(files.begin(), files.end());
  std::vector<LensfunProfile> profiles;
  for (const fs::path& file : files) try {
      pugi::xml_document document;
      if (const auto parsed = document.load_file(file.c_str()); !parsed)
        throw std::runtime_error(parsed.description());
      for (const pugi::xml_node& lens : document.child("lensdatabase").children("lens")) {
        const std::string type = lens.child_value("type");
        if (!type.empty() && type != "rectilinear") continue;
        for (const pugi::xml_node& row : lens.child("calibration").children("distortion"))
          profiles.push_back(read_profile(lens, row));
      }
    } catch (const std::exception& error) {
      throw std::runtime_error(file.string() + ": " + error.what());
    }
  return profiles;
}

std::optional<ConvertedProfile> converted(const LensfunProfile& profile) {
  const std::optional<double> corner = corner_radius(profile);
  if (!corner) return std::nullopt;
  constexpr int samples = 64;
  Eigen::Matrix<double, samples, 3> powers;
  Eigen::Matrix<double, samples, 1> moved;
  for (int i = 0; i < samples; ++i) {
    const double r = (i + 1.0) / samples, s = r * r;
    powers.row(i) << r * s, r * s * s, r * s * s * s;
    moved[i] = seen_at(profile, r * *corner) / *corner - r;
  }
  const Eigen::Vector3d k = powers.colPivHouseholderQr().solve(moved);
  const Distortion lens{.k1 = k[0], .k2 = k[1], .k3 = k[2]};  // unit: the corner's undistorted radius

  // The photograph is the lens' final frame; the base that a border-free crop would need lies around it.
  constexpr int width = 6000;
  Pinhole photo = pinhole_from_hfov(width, static_cast<int>(std::lround(width / profile.aspect)), 1);
  photo.fx = photo.fy = 0.5 * photo.height * *corner;
  const FrameCertificate base = certify_frame(lens, photo);
  if (!base.valid()) return std::nullopt;
  const double unit = 0.5 * base.rectangle.diagonal().norm();
  return ConvertedProfile{rescaled(lens, unit), (powers * k - moved).cwiseAbs().maxCoeff() / unit};
}

}  // namespace cps
