#pragma once

namespace scree::ranks {

// Whether mpirun or srun has started other processes of the same program together with this one. Reads the
// environment alone and does not load MPI.
bool has_fellow_tasks();

}  // namespace scree::ranks
