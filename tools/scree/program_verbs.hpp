#pragma once

#include "support/verbs.hpp"

#include <functional>

namespace scree::tool {

// Each adds its verb.
void add_run_verb(CommandLine& line);
// `resume_study` goes on where the directory has results of a study.
void add_resume_verb(CommandLine& line, const std::function<ExitStatus()>& resume_study);
void add_check_verb(CommandLine& line);
void add_describe_verb(CommandLine& line);
void add_render_verb(CommandLine& line);
void add_chart_verb(CommandLine& line);
void add_report_verb(CommandLine& line);
void add_export_verb(CommandLine& line);
void add_campaign_verb(CommandLine& line);
void add_bench_verb(CommandLine& line);
void add_new_plugin_verb(CommandLine& line);
void add_test_plugin_verb(CommandLine& line);

}  // namespace scree::tool
