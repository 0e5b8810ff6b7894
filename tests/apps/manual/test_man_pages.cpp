#include <algorithm>
#include <cctype>
#include <regex>

#include "files/files.h"
#include "sampler/recipe/recipe_keys.h"
#include "tests/apps/manual/programs.h"
#include "tests/temporary_folder.h"

using namespace cps;

namespace {

/// The page as a terminal 80 columns wide shows it; man's warnings, if there are any, come first.
std::string rendered(const std::filesystem::path& page) {
  return output_of("MANROFFSEQ= MANWIDTH=80 LC_ALL=C.UTF-8 man --warnings -E UTF-8 -P cat -l " +
                   page.string());
}

bool has_word(const std::string& text, const std::string& word) {
  const auto is_inside = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_';
  };
  for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1))
    if ((at == 0 || !is_inside(text[at - 1])) &&
        (at + word.size() == text.size() || !is_inside(text[at + word.size()])))
      return true;
  return false;
}

}  // namespace

TEST_CASE("every verb has a man page, which man shows without a warning and with every option") {
  const TemporaryFolder folder;
  for (const std::string& program : built_programs())
    for (const std::string& page : pages_of(program)) {
      INFO(page);
      const std::filesystem::path file = folder.path / (page + ".1");
      write_file(file, program_output(program, "--man " + page));
      CHECK(output_of("LC_ALL=C.UTF-8 man --warnings=w -E UTF-8 -l -Tutf8 -Z " + file.string() +
                      " >/dev/null") == "");
      const std::string text = rendered(file);
      for (const char* part : {"NAME\n", "SYNOPSIS\n", "DESCRIPTION\n", "EXIT STATUS\n", "SEE ALSO\n"})
        CHECK_THAT(text, Catch::Contains(part));
      CHECK_THAT(text, Catch::Contains("\n       " + page + " - "));
      const std::vector<std::string> options = page == "cps" || page == "cps-lens"
                                                   ? std::vector<std::string>{}
                                                   : options_in_help(program, verb_of_page(page));
      CHECK((options.size() > 1 || page == "cps" || page == "cps-lens"));
      for (const std::string& option : options) {
        INFO(option);
        CHECK(has_word(text, option));
      }
    }
}

TEST_CASE("the pages are those of all verbs, and name only pages that exist") {
  std::vector<std::string> pages;
  for (const std::string& program : built_programs())
    for (const std::string& page : pages_of(program)) pages.push_back(page);
  const bool has_trainer = built_programs().size() > 1;
  const auto exists = [&](const std::string& page) {
    return std::find(pages.begin(), pages.end(), page) != pages.end() || page == "cps-slurm" ||
           (!has_trainer && (page == "cps-train" || page == "cps-eval" || page == "cps-predict"));
  };
  bool is_list = false;
  int verbs = 0;
  for (const std::string& line : lines_of(output_of(CPS_PROGRAM " help"))) {
    if (is_list && line.empty()) break;
    if (is_list && line.size() > 2 && line[2] != ' ') {
      CHECK(exists("cps-" + line.substr(2, line.find(' ', 2) - 2)));
      ++verbs;
    }
    if (line == "Verbs:") is_list = true;
  }
  CHECK(verbs >= 14);
  const std::regex reference(R"(\\fB(cps[^\\]*(?:\\-[^\\]*)*)\\fR\(1\))");
  for (const std::string& program : built_programs())
    for (const std::string& page : pages_of(program)) {
      const std::string text = program_output(program, "--man " + page);
      for (std::sregex_iterator match(text.begin(), text.end(), reference), end; match != end; ++match) {
        const std::string named = std::regex_replace((*match)[1].str(), std::regex(R"(\\-)"), "-");
        INFO(page << " names " << named);
        CHECK(exists(named));
      }
    }
}

TEST_CASE("cps generate's page has every key of a recipe") {
  const TemporaryFolder folder;
  write_file(folder.path / "generate.1", output_of(CPS_PROGRAM " --man cps-generate"));
  const std::string text = rendered(folder.path / "generate.1");
  const Recipe recipe;
  for_each_recipe_key(recipe, [&](const char* key, const auto&, const char*) {
    INFO(key);
    CHECK(has_word(text, std::string("--") + key));
  });
}

TEST_CASE("the examples of the pages use options that exist") {
  for (const std::string& program : built_programs())
    for (const std::string& page : pages_of(program)) {
      if (page == "cps") continue;
      const std::string verb = verb_of_page(page);
      const std::string help = program_output(program, verb + " --help");
      const std::size_t examples = help.find("\nExamples:\n");
      INFO(page);
      if (page != "cps-lens") REQUIRE(examples != help.npos);
      if (examples == help.npos) continue;
      const std::vector<std::string> known = options_in_help(program, verb);
      const std::string text = help.substr(examples);
      const std::regex option(R"((^|\s)(--[a-z][a-z_-]*))");
      for (std::sregex_iterator match(text.begin(), text.end(), option), end; match != end; ++match) {
        INFO((*match)[2]);
        CHECK(std::find(known.begin(), known.end(), (*match)[2].str()) != known.end());
      }
      for (const std::string& line : lines_of(text))
        if (line.starts_with("  cps")) CHECK_THAT(line, Catch::StartsWith("  cps " + verb + " "));
    }
}

TEST_CASE("an unknown page or shell is wrong usage, in one line") {
  for (const char* arguments : {"--man cps-fly", "--completion fish", "--completion"}) {
    FILE* pipe = popen((std::string(CPS_PROGRAM " ") + arguments + " 2>&1").c_str(), "r");
    char line[256] = {}, rest[2] = {};
    CHECK(fgets(line, sizeof line, pipe) != nullptr);
    CHECK(fgets(rest, sizeof rest, pipe) == nullptr);
    CHECK(WEXITSTATUS(pclose(pipe)) == 2);
    CHECK_THAT(line, Catch::StartsWith("cps: --"));
  }
}

TEST_CASE("the page of cps-slurm, written by hand, shows without a warning") {
  const std::string page = CPS_SOURCE "/apps/slurm/cps-slurm.1";
  CHECK(output_of("LC_ALL=C.UTF-8 man --warnings=w -E UTF-8 -l -Tutf8 -Z " + page + " >/dev/null") == "");
  CHECK_THAT(rendered(page), Catch::Contains("SHARDS [SBATCH OPTION ...] -- --recipe FILE --out DIR"));
}
