#include <boost/program_options.hpp>
#include <catch2/catch.hpp>

#include "apps/manual/help_text.h"
#include "apps/manual/man_page.h"
#include "apps/manual/option_groups.h"
#include "apps/manual/paragraphs.h"

using namespace cps;
namespace po = boost::program_options;

namespace {

/// Options of every kind that the verbs have.
po::options_description sample_options() {
  po::options_description options("Options"), further("Further keys (in the file, too)");
  options.add_options()("out,o", po::value<std::string>()->value_name("FILE")->required(),
                        "the file to write");
  options.add_options()(
      "sigma", po::value<double>()->default_value(0.1),
      "a help text so long that Boost breaks it twice or more, wherever it likes, and that has a "
      "- in it: even an --option");
  options.add_options()("quiet", po::bool_switch(), "say nothing")("json", "print JSON");
  further.add_options()("cities", po::value<std::vector<double>>()->multitoken(), "numbers")(
      "mirror", po::value<bool>(), "true or false")("name", po::value<std::string>()->default_value("a b"),
                                                    "a name");
  options.add(further);
  return options;
}

const Manual sample{
    .name = "cps sample",
    .summary = "do a thing",
    .synopsis = {"[--sigma NUMBER] [--cities NUMBER ...] [--name TEXT] (--quiet | --json) -o FILE.png",
                 "--json"},
    .description =
        "\nDoes a thing\nin two lines.\n\n.A dot, a \\ and Brown\xE2\x80\x93"
        "Conrady's --sigma.\n\n  kept\n    as it is\n",
    .examples = {{"cps sample -o a.png", "writes a.png"}},
    .see_also = {"cps lens check"},
};

}  // namespace

TEST_CASE("options are listed with letter, value, default and group") {
  const std::vector<OptionGroup> groups = option_groups(sample_options());
  REQUIRE(groups.size() == 2);
  CHECK(groups[0].title == "Options");
  CHECK(groups[1].title == "Further keys (in the file, too)");
  REQUIRE(groups[0].options.size() == 4);
  REQUIRE(groups[1].options.size() == 3);
  const OptionEntry &out = groups[0].options[0], &sigma = groups[0].options[1], &quiet = groups[0].options[2],
                    &json = groups[0].options[3], &cities = groups[1].options[0],
                    &mirror = groups[1].options[1], &name = groups[1].options[2];
  CHECK((out.name == "out" && out.letter == 'o' && out.placeholder == "FILE" && out.default_text.empty()));
  CHECK(out.help == "the file to write");
  CHECK((sigma.name == "sigma" && sigma.letter == 0 && sigma.placeholder == "NUMBER"));
  CHECK(sigma.default_text == "0.1");
  CHECK_THAT(sigma.help, Catch::EndsWith("even an --option"));
  CHECK((quiet.placeholder.empty() && json.placeholder.empty()));
  CHECK((quiet.default_text.empty() && json.default_text.empty()));
  CHECK((cities.placeholder == "NUMBER" && mirror.placeholder == "BOOL" && name.placeholder == "TEXT"));
  CHECK(name.default_text == "a b");
}

TEST_CASE("help fills 80 columns and keeps what is bracketed together") {
  const std::string text = help_text(sample, option_groups(sample_options()));
  CHECK(text ==
        R"(cps sample: do a thing

Usage: cps sample [--sigma NUMBER] [--cities NUMBER ...] [--name TEXT]
                  (--quiet | --json) -o FILE.png
       cps sample --json

Does a thing in two lines.

.A dot, a \ and Brown)"
        "\xE2\x80\x93"
        R"(Conrady's --sigma.

  kept
    as it is

Options:
  -o, --out FILE      the file to write
      --sigma NUMBER  a help text so long that Boost breaks it twice or more,
                      wherever it likes, and that has a - in it: even an
                      --option [0.1]
      --quiet         say nothing
      --json          print JSON

Further keys (in the file, too):
      --cities NUMBER  numbers
      --mirror BOOL    true or false
      --name TEXT      a name [a b]

Exit status: 0 done; 1 failed; 2 wrong usage.

Examples:
  cps sample -o a.png
      writes a.png
)");
}

TEST_CASE("a man page is ASCII, and what troff could take for its own is escaped") {
  const std::string page = man_page(sample, option_groups(sample_options()));
  for (const char c : page) CHECK(static_cast<unsigned char>(c) < 0x80);
  CHECK_THAT(page, Catch::StartsWith(".TH \"CPS-SAMPLE\" 1 \"\" \"cps "));
  CHECK_THAT(page, Catch::Contains("\ncps\\-sample \\- do a thing\n"));
  CHECK_THAT(page, Catch::Contains("\nDoes a thing in two lines.\n"));
  CHECK_THAT(page, Catch::Contains("\n\\&.A dot, a \\e and Brown\\[u2013]Conrady's \\-\\-sigma.\n"));
  CHECK_THAT(page, Catch::Contains(".nf\n  kept\n    as it is\n.fi\n"));
  CHECK_THAT(page, Catch::Contains(".TP\n\\fB\\-o\\fR, \\fB\\-\\-out\\fR \\fIFILE\\fR\nthe file to write\n"));
  CHECK_THAT(page, Catch::Contains("\\-\\-option [0.1]\n"));
  CHECK_THAT(page, Catch::Contains(".SS Further keys (in the file, too)\n"));
  CHECK_THAT(page, Catch::Contains(
                       "(\\fB\\-\\-quiet\\fR | \\fB\\-\\-json\\fR) \\fB\\-o\\fR \\fIFILE.png\\fR\n.YS\n"));
  CHECK_THAT(page, Catch::EndsWith(".SH SEE ALSO\n\\fBcps\\-lens\\-check\\fR(1)\n"));
}

TEST_CASE("lines are broken between words, and a word that is too long has its own line") {
  CHECK(filled("a bb ccc", 80, 2, 0) == "a bb ccc");
  CHECK(filled("aa bb cc", 5, 2, 0) == "aa bb\n  cc");
  CHECK(filled("a bbbbbbbbbb c", 5, 1, 0) == "a\n bbbbbbbbbb\n c");
  CHECK(filled("ää öö", 5, 0, 0) == "ää öö");
  CHECK(filled("ää öö", 5, 0, 1) == "ää\nöö");
}
