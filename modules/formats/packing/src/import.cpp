#include <algorithm>
#include <array>
#include <optional>
#include <string>

#include <fmt/format.h>

#include <scree/error.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/files/text_reader.hpp>
#include <scree/packing/bead_file.hpp>
#include <scree/packing/csv.hpp>
#include <scree/packing/import.hpp>
#include <scree/packing/lammps.hpp>
#include <scree/packing/other_codes.hpp>

namespace scree::packing {

namespace {

constexpr std::array<std::string_view, 6> format_names = {"csv",         "beads", "lammps_data",
                                                          "lammps_dump", "table", "mercury"};
constexpr std::array<const char*, 6> format_nouns = {"CSV",
                                                     "a list of beads in a periodic box",
                                                     "a data file of LAMMPS or LIGGGHTS",
                                                     "a dump of LAMMPS or LIGGGHTS",
                                                     "",
                                                     ""};

bool begins_with_number(std::string_view word) {
  return !word.empty() && std::string_view("+-.0123456789").find(word[0]) != std::string_view::npos;
}

// The header of a data file is short and contains a line "<number> atoms".
bool has_atom_count(files::TextReader& reader) {
  constexpr int header_lines = 100;
  for (int k = 0; k < header_lines && reader.next_words(); ++k) {
    const auto& words = reader.words();
    if (words.size() == 2 && words[1].text == "atoms") return true;
  }
  return false;
}

// Whether comments before the first words name the columns of a table.
bool has_named_columns(std::string_view text) {
  files::TextReader reader(text, "");
  while (reader.next() && reader.words().empty()) {
    const std::size_t hash = reader.line().find('#');
    if (hash != std::string_view::npos && names_columns(reader.line().substr(hash + 1))) return true;
  }
  return false;
}

// Of lines of words separated by blanks, by the width of the present line and the next.
std::optional<FileFormat> format_of_numbers(files::TextReader& reader) {
  if (names_columns(reader.line())) return FileFormat::table;
  const auto& words = reader.words();
  const std::size_t first = words.size();
  if (!std::all_of(words.begin(), words.end(),
                   [](const files::Token& word) { return begins_with_number(word.text); }))
    return std::nullopt;
  const std::size_t second = reader.next_words() ? reader.words().size() : 0;
  if (first == 3 && second != 3) return FileFormat::beads;
  if ((first == 6 || first == 8) && (second == 8 || second == 14)) return FileFormat::mercury;
  return FileFormat::table;
}

Packing parse_as(std::string_view text, const std::string& name, FileFormat format,
                 const ImportOptions& options) {
  switch (format) {
    case FileFormat::beads:
      return parse_beads(text, name, options);
    case FileFormat::lammps_data:
      return parse_lammps_data(text, name, options);
    case FileFormat::lammps_dump:
      return parse_lammps_dump(text, name, options);
    case FileFormat::table:
      return parse_table(text, name, options);
    case FileFormat::mercury:
      return parse_mercury(text, name, options);
    default:
      return parse_csv(text, name, options);
  }
}

Packing parse(std::string_view text, const std::string& name, FileFormat format,
              const ImportOptions& options) {
  Packing packing = parse_as(text, name, format, options);
  if (packing.format.empty()) packing.format = format_nouns[std::size_t(format)];
  return packing;
}

}  // namespace

FileFormat file_format(std::string_view name) {
  for (std::size_t k = 0; k < format_names.size(); ++k)
    if (format_names[k] == name) return FileFormat(k);
  throw Error("packing", fmt::format("unknown file format {}", files::quote_token(name)),
              files::suggest_name(name, format_names));
}

FileFormat detect_format(std::string_view text, std::string_view name) {
  files::TextReader reader(text, std::string(name));
  if (text.starts_with("ITEM:")) return FileFormat::lammps_dump;
  if (has_atom_count(reader)) return FileFormat::lammps_data;
  reader.seek({});
  if (!reader.next_words()) reader.fail(1, "the file is empty", "give a packing");
  if (reader.line().find(',') != std::string_view::npos) return FileFormat::csv;
  if (has_named_columns(text)) return FileFormat::table;
  if (const auto format = format_of_numbers(reader)) return *format;
  reader.fail(
      1, "the format of the file is not recognised",
      reader.line().find(';') != std::string_view::npos
          ? "separate the columns of a CSV file by commas, and write decimal points"
          : "give CSV with a header line, a table 'x y z r', a .data file of MercuryDPM, or a data or dump "
            "file of LAMMPS");
}

Packing parse_packing(std::string_view text, const std::string& name, const ImportOptions& options) {
  if (text.starts_with(files::byte_order_mark)) text.remove_prefix(files::byte_order_mark.size());
  return parse(text, name, options.columns.empty() ? detect_format(text, name) : FileFormat::table, options);
}

Packing read_packing(const std::filesystem::path& path, const ImportOptions& options) {
  return parse_packing(files::read_text(path), path.string(), options);
}

Packing read_packing(const std::filesystem::path& path, FileFormat format, const ImportOptions& options) {
  return parse(files::read_text(path), path.string(), format, options);
}

}  // namespace scree::packing
