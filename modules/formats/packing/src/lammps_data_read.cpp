#include "body_field.hpp"
#include "material_types.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/files/text.hpp>
#include <scree/files/text_file.hpp>
#include <scree/packing/lammps.hpp>

namespace scree::packing {

namespace {

// Sections without information on the state of the bodies.
constexpr std::string_view skipped_sections[] = {"Masses",           "Pair Coeffs",      "PairIJ Coeffs",
                                                 "Bond Coeffs",      "Angle Coeffs",     "Dihedral Coeffs",
                                                 "Improper Coeffs",  "BondBond Coeffs",  "BondAngle Coeffs",
                                                 "Atom Type Labels", "Bond Type Labels", "Angle Type Labels"};
// Sections that define other shapes or bonds.
constexpr std::string_view refused_sections[] = {"Bonds",      "Angles", "Dihedrals", "Impropers",
                                                 "Ellipsoids", "Lines",  "Triangles", "Bodies"};
constexpr std::string_view refused_counts[] = {"bonds",      "angles", "dihedrals", "impropers",
                                               "ellipsoids", "lines",  "triangles", "bodies"};
constexpr std::string_view skipped_counts[] = {"atom types", "bond types", "angle types", "dihedral types",
                                               "improper types"};
constexpr std::string_view tilted_boxes[] = {"avec", "bvec", "cvec", "abc origin"};

bool contains(std::span<const std::string_view> names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Words from index `first` on, joined by single blanks: the keyword of a header line or section.
std::string joined(const std::vector<Token>& words, std::size_t first) {
  std::string result;
  for (std::size_t k = first; k < words.size(); ++k) {
    if (k > first) result += ' ';
    result += words[k].text;
  }
  return result;
}

class DataReader {
 public:
  DataReader(std::string_view text, const std::string& name, const ImportOptions& options)
      : reader_(text, name), options_(options) {
    packing_.dimension = options.dimension.value_or(3);
    packing_.periodic = options.periodic.value_or(std::array<bool, 3>{});
    packing_.bounds = Bounds{{{-0.5, -0.5, -0.5}}, {{0.5, 0.5, 0.5}}};
    packing_.own_ids = true;
  }

  Packing read() {
    if (!reader_.next()) reader_.fail(1, "the file is empty", "give a LAMMPS data file");
    require_si();
    bool more = read_header();
    while (more) more = read_section();
    if (!has_atoms_)
      reader_.fail(1, "there is no section Atoms", "add it, or check that the file is complete");
    return std::move(packing_);
  }

 private:
  void require_si() const;
  bool read_header();
  bool read_header_line(const std::vector<Token>& words);
  void read_extent(const std::vector<Token>& words, int axis);
  void require_upright_box(const std::vector<Token>& words);
  bool read_section();
  void require_sphere_style(std::string_view line);
  bool read_atoms();
  void read_atom(const std::vector<Token>& words);
  bool read_velocities();
  void read_velocity(const std::vector<Token>& words);
  bool skip_section();
  bool at_section() const;
  void store(Body& body, BodyField field, const Token& token);
  void require_count(std::int64_t found, std::string_view section);
  void refuse_surplus(std::int64_t found, std::string_view section);

  TextReader reader_;
  const ImportOptions& options_;
  Packing packing_;
  std::optional<std::int64_t> expected_;
  bool has_atoms_ = false;
  std::unordered_map<std::int64_t, std::size_t> index_of_;
};

// LAMMPS ends the title with the units of the run, as in "..., timestep = 100, units = lj".
void DataReader::require_si() const {
  constexpr std::string_view mark = "units = ";
  const std::size_t at = reader_.line().find(mark);
  if (at == std::string_view::npos) return;
  const std::size_t begin = at + mark.size(), end = reader_.line().find_first_of(" ,\t", begin);
  const Token units = reader_.trimmed(begin, std::min(end, reader_.line().size()));
  if (units.text != "si")
    reader_.fail(units.column, fmt::format("the file is in units {}", quote_token(units.text)),
                 "write it with units si");
}

// Reads up to the first section; the first line of the file is a title. Returns true if there is a section;
// its keyword is then the current line.
bool DataReader::read_header() {
  while (reader_.next_words()) {
    const auto& words = reader_.words();
    if (read_header_line(words)) continue;
    if (!expected_)
      reader_.fail(1,
                   fmt::format("the header has no number of atoms before {}", quote_token(joined(words, 0))),
                   "add a line such as '100 atoms' above the sections");
    return true;
  }
  return false;
}

bool DataReader::read_header_line(const std::vector<Token>& words) {
  const std::string keyword = joined(words, 1);
  const std::string two_values = joined(words, 2);
  if (keyword == "atoms") {
    expected_ = reader_.positive_integer(words[0], "number of atoms");
  } else if (two_values == "xlo xhi") {
    read_extent(words, 0);
  } else if (two_values == "ylo yhi") {
    read_extent(words, 1);
  } else if (two_values == "zlo zhi") {
    read_extent(words, 2);
  } else if (contains(refused_counts, keyword)) {
    if (reader_.integer(words[0], keyword) != 0)
      reader_.fail(1, fmt::format("the file has {}", keyword), "give a packing of free spheres");
  } else if (joined(words, 3) == "xy xz yz" || contains(tilted_boxes, joined(words, 3))) {
    require_upright_box(words);
  } else {
    return contains(skipped_counts, keyword) || keyword.ends_with(" per atom") ||
           keyword.ends_with("/per/atom");
  }
  return true;
}

void DataReader::read_extent(const std::vector<Token>& words, int axis) {
  Bounds& box = *packing_.bounds;
  box.lower[axis] = reader_.number(words[0], words[2].text);
  box.upper[axis] = reader_.number(words[1], words[3].text);
  if (box.lower[axis] < box.upper[axis]) return;
  reader_.fail(words[0].column, fmt::format("{} is not below {}", words[2].text, words[3].text),
               "correct the box: the lower bound comes first");
}

void DataReader::require_upright_box(const std::vector<Token>& words) {
  const bool upright = words[3].text == "xy" && reader_.number(words[0], "xy") == 0.0 &&
                       reader_.number(words[1], "xz") == 0.0 && reader_.number(words[2], "yz") == 0.0;
  if (!upright) reader_.fail(1, "the box is tilted", "give a packing in an axis-parallel box");
}

// Every section keyword begins with a capital letter; no number does.
bool DataReader::at_section() const {
  const Token content = reader_.trimmed(0, reader_.line().size());
  return !content.text.empty() && content.text[0] >= 'A' && content.text[0] <= 'Z';
}

// Returns true if another section follows.
bool DataReader::read_section() {
  const std::string keyword = joined(reader_.words(), 0);
  if (keyword == "Atoms") return read_atoms();
  if (keyword == "Velocities") return read_velocities();
  if (contains(skipped_sections, keyword)) return skip_section();
  if (contains(refused_sections, keyword))
    reader_.fail(1, fmt::format("the file has a section {}", keyword), "give a packing of free spheres");
  std::vector<std::string_view> known = {"Atoms", "Velocities"};
  known.insert(known.end(), std::begin(skipped_sections), std::end(skipped_sections));
  reader_.fail(1, fmt::format("unknown header line or section {}", quote_token(keyword)),
               files::suggest_name(keyword, known));
}

void DataReader::require_sphere_style(std::string_view line) {
  const std::size_t hash = line.find('#');
  if (hash == std::string_view::npos) return;
  const Token style = reader_.trimmed(hash + 1, line.size());
  if (style.text.empty() || style.text == "sphere" || style.text == "granular") return;
  reader_.fail(style.column, fmt::format("the atom style is {}", quote_token(style.text)),
               "write the file with atom_style sphere or granular");
}

bool DataReader::read_atoms() {
  if (has_atoms_) reader_.fail(1, "there is a second section Atoms", "leave one of them out");
  has_atoms_ = true;
  require_sphere_style(reader_.line());
  constexpr std::size_t shortest_line = 14;  // bytes of "1 1 1 1 0 0 0\n"
  packing_.bodies.reserve(std::min(std::size_t(*expected_), reader_.size() / shortest_line));
  bool more = false;
  while (!more && reader_.next_words()) {
    more = at_section();
    if (!more) read_atom(reader_.words());
  }
  require_count(std::int64_t(packing_.bodies.size()), "Atoms");
  return more;
}

void DataReader::read_atom(const std::vector<Token>& words) {
  constexpr BodyField fields[] = {BodyField::diameter, BodyField::density, BodyField::x, BodyField::y,
                                  BodyField::z};
  refuse_surplus(std::int64_t(packing_.bodies.size()), "Atoms");
  if (words.size() != 7 && words.size() != 10)
    reader_.fail(1,
                 fmt::format("{} instead of 'id type diameter density x y z [ix iy iz]'",
                             counted(words.size(), "word")),
                 "write the file with atom_style sphere or granular");
  Body body;
  store(body, BodyField::id, words[0]);
  body.material = material_of_type(words[1], options_.materials, reader_);
  for (std::size_t k = 0; k < 5; ++k) store(body, fields[k], words[k + 2]);
  for (std::size_t k = 7; k < words.size(); ++k) reader_.integer(words[k], "image flag");
  // LAMMPS computes masses of spheres in two dimensions too.
  if (packing_.dimension == 2) {
    body.mass = body.density * 4.0 / 3.0 * std::numbers::pi * body.radius * body.radius * body.radius;
    body.density = unset;
  }
  const auto [known, is_new] = index_of_.emplace(body.id, packing_.bodies.size());
  if (!is_new)
    reader_.fail(words[0].column, fmt::format("id {} is used twice", body.id), "give every atom its own id");
  packing_.bodies.push_back(std::move(body));
}

bool DataReader::read_velocities() {
  if (!has_atoms_) reader_.fail(1, "Velocities come before Atoms", "put the section Atoms first");
  IdRegister ids;
  std::int64_t found = 0;
  bool more = false;
  while (!more && reader_.next_words()) {
    more = at_section();
    if (more) break;
    refuse_surplus(found++, "Velocities");
    const auto& words = reader_.words();
    read_velocity(words);
    ids.add(reader_.integer(words[0], "id"), words[0], reader_);
  }
  require_count(found, "Velocities");
  return more;
}

void DataReader::read_velocity(const std::vector<Token>& words) {
  constexpr BodyField fields[] = {BodyField::vx, BodyField::vy, BodyField::vz,
                                  BodyField::wx, BodyField::wy, BodyField::wz};
  if (words.size() != 7)
    reader_.fail(1, fmt::format("{} instead of 'id vx vy vz wx wy wz'", counted(words.size(), "word")),
                 "write the file with atom_style sphere or granular");
  const std::int64_t id = reader_.integer(words[0], "id");
  const auto known = index_of_.find(id);
  if (known == index_of_.end())
    reader_.fail(words[0].column, fmt::format("there is no atom {}", id),
                 "give velocities of listed atoms only");
  for (std::size_t k = 0; k < 6; ++k) store(packing_.bodies[known->second], fields[k], words[k + 1]);
}

bool DataReader::skip_section() {
  while (reader_.next_words())
    if (at_section()) return true;
  return false;
}

void DataReader::store(Body& body, BodyField field, const Token& token) {
  set_field(body, field, token, reader_);
  if (packing_.dimension == 2) require_planar(body, field, token, reader_);
}

void DataReader::require_count(std::int64_t found, std::string_view section) {
  if (found == *expected_) return;
  reader_.fail(
      1,
      fmt::format("section {} ends after {} of {}", section, found, counted(std::size_t(*expected_), "line")),
      "complete the file, or correct the number of atoms in its header");
}

void DataReader::refuse_surplus(std::int64_t found, std::string_view section) {
  if (found < *expected_) return;
  reader_.fail(1,
               fmt::format("the header gives {}, and section {} has more",
                           counted(std::size_t(*expected_), "line"), section),
               "correct the number of atoms in the header");
}

}  // namespace

Packing parse_lammps_data(std::string_view text, const std::string& name, const ImportOptions& options) {
  return checked_import(DataReader(text, name, options).read(), name);
}

Packing read_lammps_data(const std::filesystem::path& path, const ImportOptions& options) {
  return parse_lammps_data(files::read_text(path), path.string(), options);
}

}  // namespace scree::packing
