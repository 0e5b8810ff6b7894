#pragma once

namespace cps {

/// The JavaScript of the lens picker. It reads the lenses from the JSON in #lens-data, and draws the one that
/// the list #lens names into the SVG #lens-drawing and its numbers into the table #lens-numbers. The page's
/// fragment names a lens as well: report.html#lens=<group folder>.
extern const char* const lens_picker_script;

}  // namespace cps
