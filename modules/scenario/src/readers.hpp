#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include <scree/branching.hpp>
#include <scree/document/document.hpp>
#include <scree/document/table.hpp>
#include <scree/domain.hpp>
#include <scree/packing/packing.hpp>
#include <scree/packing/radius_distribution.hpp>
#include <scree/packing/random.hpp>
#include <scree/packing/region.hpp>
#include <scree/pair_search.hpp>
#include <scree/parameters.hpp>
#include <scree/particles.hpp>
#include <scree/plugin_host.hpp>
#include <scree/scenario/charts.hpp>
#include <scree/scenario/names.hpp>
#include <scree/scenario/plan.hpp>
#include <scree/scenario/study_table.hpp>
#include <scree/scenario/table_keys.hpp>
#include <scree/scene.hpp>
#include <scree/scene_record.hpp>
#include <scree/stage.hpp>

// The readers of the tables of a scenario; those of one source stand under its name. All throw Error at
// the wrong key.
namespace scree::scenario {

// Does work whose errors then name the position of the key in the file, or of the table if it has no such
// key.
template <class Work>
decltype(auto) placed(const document::Table& table, std::string_view key, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw error.at(table.place(key));
  }
}

// lattice_reader.cpp

// The bodies of [particles] with lattice and radius. origin: is set to what BodySource has.
packing::Packing read_lattice_bodies(const document::Table& particles, int dimension, packing::Random& random,
                                     std::string& origin);
// The radii of [particles].
packing::RadiusDistribution read_radius(const document::Table& particles);
// A vector of `dimension` numbers; 0 if it is absent and not required.
Vec3 read_vector(const document::Table& table, std::string_view key, int dimension, bool required);
// Throws Error at the key if this number of bodies does not fit into memory. To be called before anything is
// allocated: a system without memory ends a program without a message.
void check_body_memory(const document::Table& table, std::string_view key, double bodies);

// cloud_reader.cpp

// The table `region` of [particles].
packing::Region read_region(const document::Table& region, int dimension);
// The bodies of [particles] with random, region and radius, clear of other bodies. origin: is set to what
// BodySource has.
packing::Packing read_random_bodies(const document::Table& particles, int dimension, packing::Random& random,
                                    std::vector<Sphere> others, std::string& origin);

// material_reader.cpp

// A [[material]].
struct Material {
  std::string name;
  double density;  // (kg/m³)
};
// All materials; at least one, with different names.
std::vector<Material> read_materials(const document::Table& root);
std::vector<std::string> names_of(const std::vector<Material>& materials);

// material_shares.cpp

// Gives bodies without a material one at random, so that the number of each follows the shares { glass = 0.7,
// steel = 0.3 } to less than one body.
void share_materials(const document::Table& table, const std::vector<Material>& materials,
                     packing::Random& random, std::vector<packing::Body>& bodies);

// state_reader.cpp

// Path of the state that [particles] names: in or below `folder`, the working folder, or a folder in the
// environment variable SCREE_STATE_PATH=DIR:DIR.
std::filesystem::path find_state(const document::Table& particles, const std::filesystem::path& folder);
std::shared_ptr<const State> read_state(const document::Table& particles,
                                        const std::filesystem::path& folder);
Branching read_branching(const document::Table& particles);
// Throws Error unless the ids are above 0 and differ.
void check_ids(const std::vector<Body>& bodies);
// The bodies of a state, with the materials of the scenario that have the same names.
std::vector<Body> bodies_of(const document::Table& particles, const State& state,
                            const std::vector<Material>& materials);

// input_files.cpp

// A file from which a scene takes bodies: the key that names it, "particles.file" or "particles[1].state",
// and its absolute path.
struct BodyFile {
  std::string key;
  std::filesystem::path path;
};
std::vector<BodyFile> body_files(const document::Document& document, const std::filesystem::path& scenario);

// packing_reader.cpp

// The bodies of [particles] with file, and their copies. origin: is set to what BodySource has.
packing::Packing read_packing_of_file(const document::Table& particles, int dimension,
                                      const std::filesystem::path& folder,
                                      const std::vector<Material>& materials, std::string& origin);

// spring_reader.cpp

// A [particles] with springs: its table, the ids of its bodies, and the frame of its dump.
struct SpringSource {
  document::Table table;
  std::unordered_set<std::int64_t> ids;
  std::optional<std::int64_t> timestep;
};
// Adds the springs of a table; `bodies` are those of the scene.
void read_springs(const SpringSource& source, int dimension, const std::filesystem::path& folder,
                  const std::vector<Body>& bodies, std::vector<Scene::Spring>& result);

// body_reader.cpp

// Adds material, mass and inertia to a body: a sphere in 3D (I = 2mR²/5), a disc of unit thickness in 2D
// (I = mR²/2). Throws Error at `t` unless mass and inertia are positive and finite.
Body complete_body(const document::Table& t, const packing::Body& from, int dimension,
                   const std::vector<Material>& materials);
// The body of a [[particle]].
Body read_single_body(const document::Table& particle, int dimension, const std::vector<Material>& materials);

// body_lots.cpp

// The bodies of one [[particles]] or [[particle]].
struct BodyLot {
  document::Table table;
  std::string name;    // [[particle]]s without one share it
  std::string origin;  // as in BodySource
  std::vector<Body> bodies;
  Domain box;            // of a packing; not periodic without one
  bool own_ids = false;  // those above 0 are given ones; else they only number the bodies
  std::optional<std::int64_t> timestep = {};  // of the frame of a dump
};
// A lot without bodies for each table, [[particle]] last. Names differ.
std::vector<BodyLot> body_lots(const document::Table& root);
// Numbers the bodies without an id after the largest id. keep_all: ids that only number bodies are kept too.
// Throws Error if two bodies have the same id.
void number_bodies(const document::Table& root, std::vector<BodyLot>& lots, bool keep_all);
std::vector<BodySource> sources_of(const std::vector<BodyLot>& lots);

// particles_reader.cpp

// The periodic box of a packing; name: of its table, empty if it is the only one.
struct PackingBox {
  std::string name;
  Domain domain;
};
struct ReadBodies {
  std::vector<Body> bodies;
  std::vector<BodySource> sources;
  std::vector<PackingBox> boxes;
  std::vector<Scene::Spring> springs = {};
  std::shared_ptr<const State> state = nullptr;  // in which bodies were; null for new packings
  Branching branching = {};
};
// The bodies of all [[particles]] and [[particle]], at least one. File names are relative to `folder`.
ReadBodies read_bodies(const document::Table& root, int dimension, const std::vector<Material>& materials,
                       std::uint64_t seed, const std::filesystem::path& folder);

// group_reader.cpp

// Applies the [[group]]s, in their order, to the bodies of the scene, which has its materials. sources: of
// its bodies.
void read_groups(const document::Table& root, const std::vector<BodySource>& sources, Scene& scene);
// Throws Error if pictures show groups and there are none.
void check_colored_groups(const document::Table& root);
// For a [[probe]]: 1 for the bodies that its keys `groups` and `leave_out` exclude; empty without these keys.
std::vector<std::uint8_t> read_left_out(const document::Table& probe, const Scene& scene);

// group_motion_reader.cpp

// What a [[group]] gives its bodies (indices): which components are held, velocities, and functions of time,
// for which it adds a BodyGroup to the scene; it may be given nothing. moved: of each body, the components
// that follow a function of a group before.
void read_group_motion(const document::Table& group, const std::string& name,
                       const std::vector<std::uint32_t>& bodies, std::vector<freedom::Mask>& moved,
                       Scene& scene);

// mesh_reader.cpp

// The numbers of a mesh whose file the key of a table names.
using MeshReader = std::function<std::vector<double>(const document::Table& table, const char* key)>;
// Reads files relative to a folder.
MeshReader read_meshes_from(const std::filesystem::path& folder);
// Takes the mesh of each boundary, in their order, from the record of a run instead.
MeshReader recorded_meshes(const std::vector<RecordedPlugin>& boundaries);
// For tables that have none.
std::vector<double> no_mesh(const document::Table& table, const char* key);

// plugin_parameters.cpp

// The plug-in that the key `plugin` of the table names.
const scree_plugin& find_plugin(const document::Table& table, scree_kind kind, PluginHost& host);
// The numbers of a list; without one, a list has numbers alone.
using ListReader = std::function<std::vector<double>(const document::Table& table, const char* key)>;
// Copies the keys of a table that the plug-in declares to `parameters`; other keys, and columns of other
// probes, are left for the caller.
void read_parameters(const document::Table& table, int dimension, const MeshReader& read_mesh,
                     Parameters& parameters, const ListReader& read_list = {});
// Throws Error at the table unless all required parameters are given.
void check_complete(const document::Table& table, const Parameters& parameters);

// wall_names.cpp

// A list of a probe; if its key ends with `walls` or `surfaces`, planes or surfaces may have their names in
// place of their numbers from 1.
std::vector<double> read_numbers_or_walls(const document::Table& table, const char* key, const Scene& scene);

// program_reader.cpp

// A function of time: a number, or a table whose keys determine its kind. Returns the numbers of a Program
// (see program.hpp of the framework).
std::vector<double> read_program(const document::Table& table, const std::string& key);
// The same of the table that is the value of a key, or an element of it.
std::vector<double> read_program_of(const document::Table& function, const std::string& key);

// instances.cpp

// Laws, boundaries and body forces of a scene with their parameters, by the names used in stages.
struct Instances {
  std::vector<Stage::Change> all;
  UniqueNames names{"law, boundary or force"};
  MeshReader read_mesh = no_mesh;
};
// Reads one table of [[contact]], [[boundary]] or [[body_force]], checks it and adds it to the instances. The
// scene must have its bodies already.
const Stage::Change& read_instance(const document::Table& table, scree_kind kind, PluginHost& host,
                                   const Scene& scene, Instances& instances);
// The instance with the parameters in `table` (of a stage) replaced, checked.
Stage::Change changed_instance(const document::Table& table, const Stage::Change& old, const Scene& scene);

// contact_reader.cpp

// Reads the [[contact]] laws and assigns one to each pair of materials. The scene must have its materials.
void read_contacts(const document::Table& root, PluginHost& host, Scene& scene, Instances& instances);

// stage_reader.cpp

// Reads the [[stage]]s, or makes one stage of [time] duration. A change by a stage persists in the following
// stages. The scene must be complete except for what depends on the stages. There may be none with the table
// of a study; without `studies`, the scenario has been checked before and there may be none in any case.
std::vector<Stage> read_stages(const document::Table& root, const Scene& scene, Instances instances,
                               const StudyTables* studies, std::vector<std::string>& warnings);
// A time (s) of at least one step and at most 1e12 steps.
double read_steps(const document::Table& table, const Key& key, double step);

// until_reader.cpp

// The table `until` of a stage; columns are found by find_conditions(), once the probes are known.
Until read_until(const document::Table& until, double step);
// Finds the columns of the conditions of stages.
void find_conditions(const document::Table& root, const std::vector<ProbePlan>& probes, int dimension,
                     std::vector<Stage>& stages);

// probe_reader.cpp

// Reads [[probe]]. A probe may read columns of others that stand before or after it.
std::vector<ProbePlan> read_probes(const document::Table& root, const Scene& scene,
                                   const std::vector<Stage>& stages, PluginHost& host);
ProbeColumns columns_of(const ProbePlan& probe, int dimension);

// output_reader.cpp, fields_reader.cpp and checkpoint_reader.cpp

// A time between outputs (s), at least one time step (s).
double read_interval(const document::Table& table, const Key& key, double step);
SnapshotPlan read_snapshot(const document::Table& root, int dimension, double step);
std::vector<FieldsPlan> read_fields(const document::Table& root, const Scene& scene,
                                    const std::vector<Stage>& stages);
CheckpointPlan read_checkpoint(const document::Table& root, double step);
// Sorts [[expect]] into the expectations of the run and of studies; the plan has its probes already. studies:
// as for read_stages.
void read_expectations(const document::Table& root, const StudyTables* studies, Plan& plan);

// plan_checks.cpp
// Whether a law of the scene or of a stage makes bodies rotate, so that spins exist from the start.
bool needs_spin(const Plan& plan);
// Notes whether probes, snapshots and laws need orientations and the forces of single contacts.
void note_needs(Plan& plan);
// Throws Error if there is no energy audit and a stage, probe or expectation needs it.
void check_audit(const document::Table& root, const Plan& plan);
// Refuses pictures in a build without them, before anything is computed or written.
void check_pictures(const document::Table& root, const Plan& plan);

}  // namespace scree::scenario
