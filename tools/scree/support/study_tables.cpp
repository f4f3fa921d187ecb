#include "support/study_tables.hpp"

#include <scree/spectrum/spectrum_plan.hpp>

namespace scree::tool {

const scenario::StudyTables& study_tables() {
  static const scenario::StudyTables all = {spectrum::spectrum_table()};
  return all;
}

}  // namespace scree::tool
