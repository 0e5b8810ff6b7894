#pragma once

#include <set>
#include <string>

#include "dataset/report/survey.h"
#include "files/plot.h"

namespace cps {

/// The places of one scene from above, north up and with equal scales: for each part its places as dots, and
/// lines from them into their headings. Shows up to `max_places`, evenly chosen.
Plot place_map(const std::string& title, const std::set<MapPlace>& places, std::size_t max_places,
               const PlotFrame& frame);

/// The maps of those scenes that have most places, as HTML.
std::string maps_html(const FrameSurvey& frames);

}  // namespace cps
