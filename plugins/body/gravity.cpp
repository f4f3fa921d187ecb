// Uniform gravity.

#include <scree/body_term.hpp>

namespace {

struct Gravity {
  std::array<double, 3> acceleration = {0, 0, 0};

  static constexpr scree::About about = {"gravity", "uniform acceleration of every body",
                                         "f = m g, E = −m g·x", "David et al. 2005, equation 5"};

  void declare(scree::Declaration& d) {
    d.vector("acceleration", acceleration, "m/s^2", "g, for example [0, 0, -9.81]").required();
  }

  void apply(scree_body_batch& batch) const {
    for (int k = 0; k < 3; ++k) {
      if (!batch.force[k]) continue;
      const double g = acceleration[k];
      for (std::uint32_t i = 0; i < batch.count; ++i) {
        batch.force[k][i] += batch.mass[i] * g;
        const double crossed = batch.image[k] ? batch.image[k][i] * batch.period[k] : 0;
        batch.potential -= batch.mass[i] * g * (batch.position[k][i] + crossed);
      }
    }
  }
};

}  // namespace

SCREE_BODY_TERM_PLUGIN(Gravity)
