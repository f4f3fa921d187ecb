#include "common_sections.hpp"
#include "html.hpp"
#include "style.hpp"

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/report/page.hpp>
#include <scree/report/record.hpp>

namespace scree::report {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view generator = "<meta name=\"generator\" content=\"scree";

struct Kind {
  const char *record, *noun, *verb;
  std::string (*sections)(const Results&);
};

constexpr Kind kinds[] = {{"campaign.json", "campaign", "campaign", campaign_sections},
                          {"run.json", "run", "run", run_sections},
                          {"spectrum.json", "spectrum", "spectrum", spectrum_sections},
                          {"accuracy.json", "accuracy study", "accuracy", accuracy_sections},
                          {"modes.json", "study of modes", "modes", study_sections},
                          {"quasi_static.json", "quasi-static load", "quasi-static", study_sections}};

const Kind& kind_of(const fs::path& directory) {
  std::error_code failed;
  for (const Kind& kind : kinds)
    if (fs::is_regular_file(directory / kind.record, failed)) return kind;
  throw Error(directory.string(), "contains no results of scree",
              "give the directory of a run, a study or a campaign");
}

Json record_in(const fs::path& file) {
  Json record = parse_record(files::read_text(file));
  if (!record.is_object())
    throw Error(file.string(), "is not a record that scree has written", "run the scenario again");
  return record;
}

}  // namespace

std::string page_of(const fs::path& directory) {
  const Kind& kind = kind_of(directory);
  const Results results = {directory, record_in(directory / kind.record), kind.noun, kind.verb};
  const std::string title = escaped(title_of(results)), version = escaped(text_in(results.record, "version"));
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<title>{0}</title>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n{1} {2}\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" "
      "content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:\">\n"
      "<style>{3}</style>\n</head>\n<body>\n<header>\n<p>{4}</p>\n<h1>{0}</h1>\n</header>\n<main>\n{5}</main>\n"
      "<footer>Written by scree {2}.</footer>\n</body>\n</html>\n",
      title, generator, version, style, escaped(kind.noun), kind.sections(results));
}

bool is_page(std::string_view text) {
  constexpr std::size_t head = 4096;  // (bytes) a title may be long
  return text.substr(0, head).find(generator) != text.npos;
}

}  // namespace scree::report
