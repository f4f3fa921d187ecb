#pragma once

namespace scree::ranks {

// Whether mpirun or srun has started other processes of the same program together with this one. Reads the
// environment alone and does not load MPI.
bool is_one_of_several_tasks();
// Of these, whether this is the first, which alone reports what concerns all.
bool is_first_task();

}  // namespace scree::ranks
