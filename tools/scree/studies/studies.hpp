#pragma once

#include "support/command_line.hpp"

namespace scree::tool {

// Each adds its verb, `resume` for the results of studies.
void add_accuracy_verb(CommandLine& line);
void add_spectrum_verb(CommandLine& line);
void add_cycles_verb(CommandLine& line);
void add_fields_verb(CommandLine& line);
void add_modes_verb(CommandLine& line);
void add_quasi_static_verb(CommandLine& line);
void add_study_resume_verb(CommandLine& line);

}  // namespace scree::tool
