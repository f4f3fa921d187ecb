#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <scree/parameters.hpp>
#include <scree/plugin/abi.h>

namespace scree {

// Loads plug-in libraries `<directory>/<kind>/<name>.so` from trusted directories, each only when it is asked
// for. Kinds are the folders contact, boundary, body, probe. Beside a library `x.so` may lie builds for newer
// processors, `x86-64-v3/x.so` and `x86-64-v4/x.so`; the best one that the processor runs is taken, unless
// the environment variable SCREE_LEVEL names one (or "baseline").
class PluginHost {
 public:
  // A library that could not be used, and why.
  struct Broken {
    std::filesystem::path path;
    std::string reason;
  };

  // Directories are searched in order; the first that holds the name wins.
  explicit PluginHost(std::vector<std::filesystem::path> directories);
  ~PluginHost();
  PluginHost(const PluginHost&) = delete;
  PluginHost& operator=(const PluginHost&) = delete;

  // The plug-in of a name and kind. Throws Error naming the nearest known name, or the reason of the refusal.
  const scree_plugin& find(const std::string& name, scree_kind kind);
  // Loads every library; those that cannot be used are listed in `broken`.
  std::vector<const scree_plugin*> load_all(std::vector<Broken>& broken);
  // Names of the libraries of a kind that lie in the directories, without loading them.
  std::vector<std::string> names(scree_kind kind) const;
  const std::vector<std::filesystem::path>& directories() const { return directories_; }
  // Where the library of a name lies, empty if nowhere.
  std::filesystem::path locate(const std::string& name, scree_kind kind) const;

  // The directories of the build or install tree that the running program belongs to.
  static std::vector<std::filesystem::path> default_directories();

 private:
  struct Library;
  const scree_plugin* load(const std::filesystem::path& path);
  [[noreturn]] void refuse(const std::string& name, scree_kind kind) const;

  std::vector<std::filesystem::path> directories_;
  std::map<std::filesystem::path, std::unique_ptr<Library>> libraries_;
};

// "contact", "boundary", "body_force", "probe": the folder of a kind and its table in a scenario.
const char* kind_folder(scree_kind kind);
// "contact law", "boundary", "body force", "probe".
const char* kind_name(scree_kind kind);

// For plug-ins that do not depend on the bounding box of the scene.
inline constexpr double no_bounds[3] = {0, 0, 0};

// A plug-in with its parameters, configured in storage of its own.
template <class Interface, class Instance>
class Configured {
 public:
  // Throws Error with the plug-in's own message. lower and upper: bounding box of the scene (m).
  Configured(const Parameters& parameters, int dimension, const double (&lower)[3], const double (&upper)[3]);

  const Interface& interface() const {
    return *static_cast<const Interface*>(parameters_->plugin().interface);
  }
  const Instance& instance() const { return instance_; }
  const void* storage() const { return storage_.get(); }
  const Parameters& parameters() const { return *parameters_; }

 private:
  struct Release {
    void operator()(void* p) const { ::operator delete(p, std::align_val_t(64)); }
  };
  std::unique_ptr<const Parameters> parameters_;  // owns the numbers that the storage may point to
  std::unique_ptr<void, Release> storage_;
  Instance instance_ = {};
};

// What a body force's `configure` fills in.
struct NoInstance {};

using ConfiguredLaw = Configured<scree_contact_law, scree_contact_instance>;
using ConfiguredBoundary = Configured<scree_boundary, scree_boundary_instance>;
using ConfiguredBodyForce = Configured<scree_body_force, NoInstance>;
using ConfiguredProbe = Configured<scree_probe, scree_probe_instance>;

}  // namespace scree
