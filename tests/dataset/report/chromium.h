#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <string>

namespace cps {

/// Opens a page in headless Chromium and returns the document as it is after its scripts have run, followed
/// by what Chromium logs, its console among it. Empty without Chromium. Its profile lies beside the page.
inline std::string dom_in_chromium(const std::filesystem::path& page, int width_px, bool is_dark) {
  const std::string command =
      "command -v chromium >/dev/null && timeout 120 chromium --headless --no-sandbox --disable-gpu "
      "--no-first-run --hide-scrollbars --enable-logging=stderr --user-data-dir=" +
      (page.parent_path() / "profile").string() + " --window-size=" + std::to_string(width_px) +
      ",1000 --blink-settings=preferredColorScheme=" + (is_dark ? "0" : "1") + " --dump-dom file://" +
      page.string() + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  char buffer[65536];
  while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe)) text.append(buffer, n);
  pclose(pipe);
  return text;
}

}  // namespace cps
