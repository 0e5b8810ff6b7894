#include <algorithm>
#include <cstdlib>
#include <regex>

#include "files/files.h"
#include "sampler/recipe/recipe_keys.h"
#include "tests/apps/manual/programs.h"
#include "tests/temporary_folder.h"

using namespace cps;
namespace fs = std::filesystem;

namespace {

std::string name_of(const std::string& program) {
  return fs::path(program).filename().string();
}

/// The scripts of all programs in a folder, as they are installed, with a few files to complete.
void write_scripts(const fs::path& folder) {
  for (const std::string& program : built_programs())
    write_file(folder / name_of(program), program_output(program, "--completion bash"));
  write_file(folder / "my scene.glb", std::string("x"));
  write_file(folder / "other.png", std::string("x"));
  fs::create_directories(folder / "data");
}

/// What bash offers in that folder for a command line, whose last word is being typed.
std::vector<std::string> offered(const fs::path& folder, const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += " '" + word + "'";
  const std::string function = words[0] == "cps-train" ? "_cps_train" : "_cps";
  return lines_of(output_of("cd " + folder.string() + " && bash -uc '. ./" + words[0] + "; COMP_WORDS=(" +
                            std::regex_replace(line, std::regex("'"), "'\\''") +
                            " ); COMP_CWORD=" + std::to_string(words.size() - 1) + "; " + function +
                            "; for reply in \"${COMPREPLY[@]}\"; do echo \"$reply\"; done'"));
}

bool has(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

TEST_CASE("bash completes verbs, options and files") {
  const TemporaryFolder temporary;
  const fs::path folder = temporary.path;
  write_scripts(folder);
  using Words = std::vector<std::string>;
  CHECK(offered(folder, {"cps", "gen"}) == Words{"generate"});
  CHECK(offered(folder, {"cps", "help", "und"}) == Words{"undistort"});
  CHECK(offered(folder, {"cps", "lens", ""}) == Words{"limits", "check", "convert", "sample"});
  CHECK(offered(folder, {"cps", "lens", "ch"}) == Words{"check"});
  CHECK(offered(folder, {"cps", "city", "--tree"}) == Words{"--tree-density"});
  CHECK(offered(folder, {"cps", "city", "--tree_d"}) == Words{"--tree-density"});
  CHECK(offered(folder, {"cps", "generate", "--max-zo"}) == Words{"--max_zoom"});
  CHECK(offered(folder, {"cps", "generate", "--recipe", "demo", "--sha"}) == Words{"--shard"});
  CHECK(offered(folder, {"cps", "lens", "check", "--cam"}) == Words{"--camera"});
  for (const Words& words : {Words{"cps", "render", "my"},
                             {"cps", "render", "--seed", "3", "m"},
                             {"cps", "render", "--lens", "my"},
                             {"cps", "render", "--lens", "=", "my"},
                             {"cps", "lens", "check", "my"}})
    CHECK(offered(folder, words) == Words{"my scene.glb"});
  CHECK(has(offered(folder, {"cps", "verify", ""}), "data"));
  CHECK(has(offered(folder, {"cps", "generate", "--scene", "="}), "other.png"));
  CHECK(offered(folder, {"cps", "city", "--no-such"}).empty());
  CHECK(has(offered(folder, {"cps", "fly", "d"}), "data"));
}

TEST_CASE("completion in bash offers every verb and every option of each") {
  const TemporaryFolder temporary;
  write_scripts(temporary.path);
  for (const std::string& program : built_programs())
    for (const std::string& page : pages_of(program)) {
      if (page == "cps" || page == "cps-lens") continue;
      const std::string verb = verb_of_page(page);
      std::vector<std::string> words{name_of(program)};
      std::istringstream parts(verb);
      for (std::string part; parts >> part;) words.push_back(part);
      const std::string last = words.back();
      if (words.size() == 2) {
        words.back() = "";
        CHECK(has(offered(temporary.path, words), last));
        words.back() = last;
      }
      words.push_back("-");
      const std::vector<std::string> found = offered(temporary.path, words);
      for (const std::string& option : options_in_help(program, verb)) {
        INFO(page << " " << option);
        CHECK(has(found, option));
      }
    }
  const Recipe recipe;
  const std::vector<std::string> found = offered(temporary.path, {"cps", "generate", "--"});
  for_each_recipe_key(
      recipe, [&](const char* key, const auto&, const char*) { CHECK(has(found, std::string("--") + key)); });
}

TEST_CASE("cps completes the verbs of cps-train where its script is installed, and files where it is not") {
  const TemporaryFolder temporary;
  write_scripts(temporary.path);
  CHECK(has(offered(temporary.path, {"cps", "tr"}), "train"));
  if (built_programs().size() > 1) {
    CHECK(offered(temporary.path, {"cps", "train", "--pres"}) == std::vector<std::string>{"--preset"});
    CHECK(offered(temporary.path, {"cps-train", "eval", "--rob"}) ==
          std::vector<std::string>{"--robustness"});
  }
  fs::remove(temporary.path / "cps-train");
  CHECK(offered(temporary.path, {"cps", "train", "--pres"}).empty());
}

TEST_CASE("zsh reads the completion and has every option with its help") {
  if (std::system("command -v zsh >/dev/null") != 0) {
    WARN("zsh is not installed: its completion is not tested");
    return;
  }
  const TemporaryFolder temporary;
  for (const std::string& program : built_programs()) {
    const std::string script = program_output(program, "--completion zsh");
    const fs::path file = temporary.path / ("_" + name_of(program));
    write_file(file, script);
    CHECK_THAT(script, Catch::StartsWith("#compdef " + name_of(program) + "\n"));
    CHECK(output_of("zsh -fn " + file.string()) == "");
    for (const std::string& page : pages_of(program)) {
      if (page == "cps" || page == "cps-lens") continue;
      for (const std::string& option : options_in_help(program, verb_of_page(page))) {
        INFO(page << " " << option);
        CHECK((script.find(option + "[") != script.npos || script.find(option + "=[") != script.npos ||
               script.find("," + option + "=}'[") != script.npos ||
               script.find("," + option + "}'[") != script.npos));
      }
    }
  }
}
