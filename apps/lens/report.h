#pragma once

#include <cstdint>
#include <string>

#include "distortion/calibrated_camera.h"
#include "distortion/models/model_camera.h"

/// What `cps lens check` and `cps lens convert` print of a camera.
namespace cps {

/// One line of a report, indented: what it is about and what there is to say.
void print_line(const char* subject, const std::string& text);

/// The share of `part` in `whole`, percent; 0 of nothing.
double percent(std::int64_t part, std::int64_t whole);

/// Name, size and pinhole of a camera in a line, and its lens in another.
void print_camera(const ModelCamera& camera);

/// Prints the report on one camera of any family. Returns why its lens is refused; empty if it is one-to-one.
std::string check_camera(const ModelCamera& camera);

/// Brown–Conrady's own, with the inverses of other programs.
std::string check_brown_conrady(const CalibratedCamera& calibrated);

}  // namespace cps
