#include "exported_contacts.hpp"
#include "exported_frames.hpp"
#include "program_verbs.hpp"
#include "support/output_file.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <scree/counted.hpp>
#include <scree/error.hpp>
#include <scree/files/text_file.hpp>
#include <scree/packing/csv.hpp>
#include <scree/packing/exports.hpp>
#include <scree/packing/lammps.hpp>
#include <scree/run/written_files.hpp>

namespace scree::tool {

namespace {

namespace fs = std::filesystem;

struct ExportArguments {
  std::string source, format, out;
  bool overwrite = false;
  PluginOptions plugins;
};

constexpr const char* contacts_format = "contacts-csv";

struct Format {
  const char* name;
  const char* suffix;
  bool many_frames;  // one file can hold more than one
  std::string (*text)(const ExportedFrame&);
};

std::string dump_text(const ExportedFrame& frame, packing::Dialect dialect) {
  packing::ExportOptions options;
  options.dialect = dialect;
  options.materials = frame.materials;
  options.timestep = std::int64_t(frame.step);
  return packing::format_lammps_dump(frame.packing, options);
}

const Format formats[] = {
    {"lammps-data", ".data", false,
     [](const ExportedFrame& f) {
       packing::ExportOptions options;
       options.materials = f.materials;
       return packing::format_lammps_data(f.packing, options);
     }},
    {"lammps-dump", ".dump", true,
     [](const ExportedFrame& f) { return dump_text(f, packing::Dialect::lammps); }},
    {"liggghts-dump", ".dump", true,
     [](const ExportedFrame& f) { return dump_text(f, packing::Dialect::liggghts); }},
    {"xyz", ".xyz", true, [](const ExportedFrame& f) { return packing::format_xyz(f.packing); }},
    {"yade", ".txt", false, [](const ExportedFrame& f) { return packing::format_yade(f.packing); }},
    {"csv", ".csv", false, [](const ExportedFrame& f) { return packing::format_csv(f.packing); }}};

std::vector<std::string> format_names() {
  std::vector<std::string> names;
  for (const Format& format : formats) names.push_back(format.name);
  names.push_back(contacts_format);
  return names;
}

fs::path out_of(const ExportArguments& arguments, const std::string& suffix) {
  if (!arguments.out.empty()) return arguments.out;
  fs::path source = fs::absolute(arguments.source).lexically_normal();
  if (!source.has_filename()) source = source.parent_path();
  // The name of a directory may have a dot, as friction=0.1.
  return (fs::is_directory(source) ? source.filename() : source.stem()).string() + suffix;
}

// Whether a run or study lists the file among its own, which lie in its directory or in a folder there.
bool is_result(const fs::path& file) {
  using run::WrittenFiles;
  std::error_code failed;
  const fs::path path = fs::weakly_canonical(file, failed), here = path.parent_path();
  for (const fs::path& directory : {here, here.parent_path()}) {
    if (!fs::is_regular_file(directory / WrittenFiles::file_name, failed)) continue;
    const std::string name = path.lexically_relative(directory).generic_string();
    if (name == WrittenFiles::file_name || WrittenFiles(directory).contains(name)) return true;
  }
  return false;
}

// Throws Error if the file may not be written.
void check_out(const ExportArguments& arguments, const fs::path& out) {
  check_output_file("--out", out, true);
  std::error_code failed;
  if (!fs::exists(fs::symlink_status(out, failed))) return;
  if (out.extension() == ".h5" || fs::equivalent(out, arguments.source, failed))
    throw Error(out.string(), "holds what is exported, or another state", "give another --out");
  if (is_result(out))
    throw Error(out.string(), "is a result of scree, which exports do not replace", "give another --out");
  check_output_file("--out", out, arguments.overwrite);
}

ExitStatus export_bodies(const ExportArguments& arguments) {
  const Format& format = *std::find_if(std::begin(formats), std::end(formats),
                                       [&](const Format& f) { return f.name == arguments.format; });
  const fs::path out = out_of(arguments, format.suffix);
  check_out(arguments, out);
  std::string text;
  std::size_t frames = 0, bodies = 0;
  for_each_frame(arguments.source, format.many_frames, [&](const ExportedFrame& frame) {
    text += format.text(frame);
    bodies = frame.packing.bodies.size();
    ++frames;
  });
  files::write_atomically(out, text);
  fmt::print("{}: {}, {}\n", out.string(), counted(frames, "frame"), counted(bodies, "body", "bodies"));
  return ExitStatus::success;
}

ExitStatus export_contacts(const ExportArguments& arguments) {
  const fs::path out = out_of(arguments, "-contacts.csv");
  check_out(arguments, out);
  PluginHost host = make_host(arguments.plugins);
  const packing::ContactTable table = contacts_in(arguments.source, host);
  files::write_atomically(out, packing::format_contacts_csv(table));
  fmt::print("{}: {}\n", out.string(), counted(table.contacts.size(), "contact"));
  return ExitStatus::success;
}

}  // namespace

void add_export_verb(CommandLine& line) {
  Verb verb = line.verb(
      "export", "Write the bodies or contacts of a run or state for LAMMPS, OVITO, ASE, YADE or as a table");
  auto a = std::make_shared<ExportArguments>();
  verb.option("source", a->source, "Run directory, state (.h5), or one particles_*.vtp file")
      .required()
      .existing_path();
  verb.option("--format", a->format, "Of the file").required().one_of(format_names());
  verb.option("--out", a->out, "File; default: the name of the source with the suffix of the format, here")
      .shown_as("FILE");
  verb.flag("--overwrite", a->overwrite, "Replace the file");
  add_plugin_options(verb, a->plugins);
  verb.footer(
      "lammps-dump, liggghts-dump and xyz hold all snapshots of a run, if it has any ([snapshot] every); other\n"
      "formats its last state, or its last snapshot if it has no state. contacts-csv holds its contacts: ids of both bodies, or of a body and the name of\n"
      "the wall, unit normal, force on the first, overlap, whether it slides, point. SI units. Materials are numbered\n"
      "in the order in which bodies have them.\n"
      "Example: scree export runs/first --format xyz --out first.xyz");
  verb.action([a] { return a->format == contacts_format ? export_contacts(*a) : export_bodies(*a); });
}

}  // namespace scree::tool
