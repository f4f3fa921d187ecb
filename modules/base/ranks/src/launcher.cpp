#include <charconv>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <optional>

#include <scree/ranks/launcher.hpp>

namespace scree::ranks {
namespace {

// None if the variable is not set or is no number.
std::optional<unsigned> number_in(const char* variable) {
  const char* const text = std::getenv(variable);
  if (!text) return std::nullopt;
  unsigned number = 0;
  const char* const end = text + std::strlen(text);
  const auto [stopped, error] = std::from_chars(text, end, number);
  if (error != std::errc() || stopped != end) return std::nullopt;
  return number;
}

}  // namespace

// Variables of mpirun go before those of Slurm, whose step then consists of one daemon for each node.
// SLURM_NTASKS says nothing: in a batch script, where one process runs alone, it is what the job asked for.
bool is_one_of_several_tasks() {
  for (const char* const size : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "MV2_COMM_WORLD_SIZE"})
    if (const auto tasks = number_in(size)) return *tasks > 1;
  if (number_in("PMIX_RANK").value_or(0) > 0) return true;
  // A task other than the first belongs to a step of several, whether or not their number is known.
  return number_in("SLURM_STEP_NUM_TASKS").value_or(1) > 1 || number_in("SLURM_PROCID").value_or(0) > 0;
}

bool is_first_task() {
  for (const char* const rank :
       {"OMPI_COMM_WORLD_RANK", "PMI_RANK", "MV2_COMM_WORLD_RANK", "PMIX_RANK", "SLURM_PROCID"})
    if (const auto number = number_in(rank)) return *number == 0;
  return true;
}

}  // namespace scree::ranks
