#include <cstdlib>
#include <map>
#include <optional>
#include <string>

#include <catch2/catch.hpp>

#include <scree/ranks/launcher.hpp>

using namespace scree;

namespace {

using Variables = std::map<std::string, std::string>;

// The variables that launchers set, and no others of them, while it exists; then those of before.
class Environment {
 public:
  explicit Environment(const Variables& variables) {
    for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE", "PMIX_RANK",
                             "SLURM_STEP_NUM_TASKS", "SLURM_PROCID", "SLURM_NTASKS"}) {
      if (const char* value = std::getenv(name)) before_[name] = value;
      names_.push_back(name);
      unsetenv(name);
    }
    for (const auto& [name, value] : variables) setenv(name.c_str(), value.c_str(), 1);
  }
  ~Environment() {
    for (const std::string& name : names_) unsetenv(name.c_str());
    for (const auto& [name, value] : before_) setenv(name.c_str(), value.c_str(), 1);
  }

 private:
  std::vector<std::string> names_;
  Variables before_;
};

bool is_one_of_several(const Variables& variables) {
  const Environment environment(variables);
  return ranks::is_one_of_several_tasks();
}

}  // namespace

TEST_CASE("mpirun tells how many tasks it has started", "[launcher]") {
  CHECK_FALSE(is_one_of_several({}));
  for (const char* size : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE"}) {
    CHECK(is_one_of_several({{size, "8"}}));
    CHECK_FALSE(is_one_of_several({{size, "1"}}));
    CHECK_FALSE(is_one_of_several({{size, ""}}));
    CHECK_FALSE(is_one_of_several({{size, "-2"}}));
    CHECK_FALSE(is_one_of_several({{size, "8 tasks"}}));
  }
  CHECK(is_one_of_several({{"PMIX_RANK", "1"}}));
  CHECK_FALSE(is_one_of_several({{"PMIX_RANK", "0"}}));
}

TEST_CASE("srun tells how many tasks its step has", "[launcher]") {
  const std::string first = GENERATE("0", "3");
  CHECK(is_one_of_several({{"SLURM_NTASKS", "8"}, {"SLURM_PROCID", first}, {"SLURM_STEP_NUM_TASKS", "8"}}));
  CHECK(is_one_of_several({{"PMIX_RANK", first}, {"SLURM_PROCID", first}, {"SLURM_STEP_NUM_TASKS", "8"}}));
  CHECK_FALSE(
      is_one_of_several({{"SLURM_NTASKS", "8"}, {"SLURM_PROCID", "0"}, {"SLURM_STEP_NUM_TASKS", "1"}}));
}

TEST_CASE("the script of a batch job runs alone, whatever the job asked for", "[launcher]") {
  CHECK_FALSE(is_one_of_several({{"SLURM_NTASKS", "8"}, {"SLURM_PROCID", "0"}}));
  CHECK(is_one_of_several({{"SLURM_NTASKS", "8"}, {"SLURM_PROCID", "5"}}));
}

TEST_CASE("mpirun in a Slurm job counts its own tasks, not its daemons", "[launcher]") {
  CHECK(is_one_of_several(
      {{"OMPI_COMM_WORLD_SIZE", "8"}, {"SLURM_STEP_NUM_TASKS", "1"}, {"SLURM_PROCID", "0"}}));
  CHECK_FALSE(is_one_of_several({{"PMI_SIZE", "1"}, {"SLURM_STEP_NUM_TASKS", "2"}, {"SLURM_PROCID", "1"}}));
}
