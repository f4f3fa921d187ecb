#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <scree/parameters.hpp>
#include <scree/plugin/abi.h>

namespace scree {

// Loads plug-in libraries `<directory>/<kind>/<name>.so` from trusted directories, each on first use. The
// kinds are the folders contact, boundary, body_force and probe. Next to a library `x.so` there may be builds
// for newer processors, `x86-64-v3/x.so` and `x86-64-v4/x.so`; the best one that the processor supports is
// loaded, unless the environment variable SCREE_LEVEL selects one (or "baseline").
class PluginHost {
 public:
  // A library that could not be loaded, and the reason.
  struct Broken {
    std::filesystem::path path;
    std::string reason;
  };

  // Directories are searched in order; the first that contains the name wins.
  explicit PluginHost(std::vector<std::filesystem::path> directories);
  ~PluginHost();
  PluginHost(const PluginHost&) = delete;
  PluginHost& operator=(const PluginHost&) = delete;

  // The plug-in of a name and kind. Throws Error with the closest known name, or with the reason why the
  // library was rejected.
  const scree_plugin& find(const std::string& name, scree_kind kind);
  // Loads every library; appends to `broken` the libraries that cannot be loaded.
  std::vector<const scree_plugin*> load_all(std::vector<Broken>& broken);
  // Names of all libraries of a kind in the directories, without loading them.
  std::vector<std::string> names(scree_kind kind) const;
  const std::vector<std::filesystem::path>& directories() const { return directories_; }
  // A line "<what>; <cure>" for each loaded contact law that has only the baseline build although this
  // processor supports a faster one. Empty if SCREE_LEVEL selects a level.
  std::vector<std::string> slow_laws() const;
  // Path of the baseline library of a name; empty if there is none.
  std::filesystem::path locate(const std::string& name, scree_kind kind) const;

  // The plug-in directories of the build or install tree that contains the running program.
  static std::vector<std::filesystem::path> default_directories();

 private:
  struct Library;
  const scree_plugin* load(const std::filesystem::path& path);
  [[noreturn]] void refuse(const std::string& name, scree_kind kind) const;

  std::vector<std::filesystem::path> directories_;
  std::map<std::filesystem::path, std::unique_ptr<Library>> libraries_;
};

// "contact", "boundary", "body_force" or "probe": the folder of a kind and its table in a scenario.
const char* kind_folder(scree_kind kind);
// "contact law", "boundary", "body force" or "probe", for messages.
const char* kind_name(scree_kind kind);

// Bounding box for plug-ins that do not depend on it.
inline constexpr double no_bounds[3] = {0, 0, 0};

// An instance of a plug-in: its parameters, and the storage in which they are configured.
template <class Interface, class Instance>
class Configured {
 public:
  // lower, upper: bounding box of the bodies (m). Throws Error with the plug-in's own message.
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
  std::unique_ptr<const Parameters> parameters_;  // owns the numbers to which the storage may point
  std::unique_ptr<void, Release> storage_;
  Instance instance_ = {};
};

// Instance type of body forces, whose `configure` returns nothing.
struct NoInstance {};

using ConfiguredLaw = Configured<scree_contact_law, scree_contact_instance>;
// Whether the histories of a law begin with the components of a tangential spring.
bool keeps_spring(const scree_contact_instance& law, int dimension);
// Dimensions in which a contact law exists: 2, 3 or both.
std::vector<int> dimensions_of(const Parameters& law);
// Throws Error for a contact law that does not exist in a dimension.
void check_dimension(const Parameters& law, int dimension);
using ConfiguredBoundary = Configured<scree_boundary, scree_boundary_instance>;
using ConfiguredBodyForce = Configured<scree_body_force, NoInstance>;
using ConfiguredProbe = Configured<scree_probe, scree_probe_instance>;

}  // namespace scree
