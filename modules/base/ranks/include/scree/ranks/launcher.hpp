#pragma once

namespace scree::ranks {

// Whether mpirun or srun has started other processes of the same program together with this one. Reads the
// environment alone and does not load MPI.
bool is_one_of_several_tasks();

}  // namespace scree::ranks
