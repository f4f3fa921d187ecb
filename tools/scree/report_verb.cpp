#include "program_verbs.hpp"

#include <memory>

#include <fmt/format.h>

#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/report/page.hpp>
#include <scree/run/written_files.hpp>

namespace scree::tool {

namespace fs = std::filesystem;

namespace {

// Puts the page beside its results, which another process may be writing: it is listed in written.txt, so
// that it is replaced and removed with them. Where there is no list, as in a campaign, only another page is
// replaced.
fs::path write_page(const fs::path& directory, const std::string& page) {
  const fs::path file = directory / report::file_name;
  std::error_code failed;
  const bool is_listed_there = fs::exists(directory / run::WrittenFiles::file_name, failed);
  std::optional<run::WrittenFiles> list;
  if (is_listed_there) list.emplace(directory);
  const bool is_there = fs::exists(fs::symlink_status(file, failed));
  if (is_there && !(list && list->contains(report::file_name)) && !report::is_page(files::read_text(file)))
    throw Error(file.string(), "is there and was not written by scree", "move it elsewhere");
  if (list && (!is_there || list->contains(report::file_name)))
    list->put(report::file_name, page);
  else
    files::write_atomically(file, page);
  return file;
}

ExitStatus write_report(const fs::path& directory) {
  const fs::path file = write_page(directory, report::page_of(directory));
  fmt::print("{}\n", files::escaped(file.string()));
  return ExitStatus::success;
}

}  // namespace

void add_report_verb(CommandLine& line) {
  Verb verb = line.verb("report", "Write report.html of a run, study or campaign again, from its files");
  auto directory = std::make_shared<std::string>();
  verb.option("directory", *directory, "Directory of a run, a study or a campaign")
      .required()
      .existing_path();
  verb.footer(
      "Every run, study and campaign ends with this page: the verdict, pictures, charts, tables, balances, speed, and\n"
      "how to repeat it. One file, which needs no other and no network. While a run goes on it shows the results so far.\n"
      "Example: scree report runs/first && xdg-open runs/first/report.html");
  verb.action([directory] { return write_report(*directory); });
}

}  // namespace scree::tool
