#include <scree/scenario/run_quantities.hpp>

namespace scree::scenario {

std::vector<std::pair<std::string, double>> run_quantities(const Simulation& s) {
  const scree_energy e = s.energy();
  return {{"steps", double(s.steps())},
          {"time", s.time()},
          {"energy_residual", s.energy_residual()},
          {"momentum_residual", s.momentum_residual()},
          {"max_overlap_ratio", s.max_overlap_ratio()},
          {"min_steps_per_contact", s.min_steps_per_contact()},
          {"kinetic_energy", kinetic_energy(e)},
          {"elastic_energy", elastic_energy(e)},
          {"dissipated_energy", dissipated_energy(e)},
          {"work", e.work},
          {"neighbour_searches", double(s.rebuilds())}};
}

std::vector<std::string> run_quantity_names() {
  return {"steps",
          "time",
          "energy_residual",
          "momentum_residual",
          "max_overlap_ratio",
          "min_steps_per_contact",
          "kinetic_energy",
          "elastic_energy",
          "dissipated_energy",
          "work",
          "neighbour_searches"};
}

}  // namespace scree::scenario
