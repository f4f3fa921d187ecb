#pragma once

#include <cstddef>
#include <memory>

#include <scree/ranks.hpp>

namespace scree::ranks {

// MPI counts in int; longer messages are split into pieces of this size (bytes).
constexpr std::size_t largest_piece = std::size_t(1) << 30;

// Whether the program was built with MPI.
bool has_mpi();

// Loads MPI and joins the processes that mpirun or srun has started with this one; a process that was started
// alone is the only rank. Possible once in a process. The object is made, used and destroyed by the main
// thread, and its destructor leaves MPI:
// - at the normal end it waits for the other ranks;
// - while an exception passes it waits for some seconds. If another rank does not leave meanwhile, it would
//   wait for this one forever: the process then ends without MPI_Finalize, and mpirun ends the others.
// Throws Error (failure) if there is no MPI or it reports an error, as do the functions of Ranks.
// piece: a multiple of 16 (bytes), smaller in tests.
std::unique_ptr<Ranks> join_ranks(std::size_t piece = largest_piece);

}  // namespace scree::ranks
