// Periodic axes: bodies that leave at one face re-enter at the opposite one.

#include <scree/plugin/boundary.hpp>

namespace {

struct Periodic {
  int axes = 0;
  std::array<double, 3> lower = {};
  std::array<double, 3> upper = {};
  std::array<bool, 3> chosen = {};

  static constexpr scree::About about = {"periodic", "one or more periodic axes",
                                         "x <- x − L floor((x − lower)/L)", "—"};

  void declare(scree::Declaration& d) {
    d.choice("axes", axes, "x|y|z|xy|xz|yz|xyz", "which axes are periodic").required();
    d.vector("lower", lower, "m", "lower corner; components of other axes are ignored").required();
    d.vector("upper", upper, "m", "upper corner, likewise").required();
  }

  void prepare(const scree::Setup& setup) {
    static constexpr bool table[7][3] = {{true, false, false}, {false, true, false}, {false, false, true},
                                         {true, true, false},  {true, false, true},  {false, true, true},
                                         {true, true, true}};
    for (int k = 0; k < 3; ++k) {
      chosen[k] = table[axes][k];
      if (chosen[k] && k >= setup.dimension())
        return setup.refuse("a 2D scene has no z axis; choose x, y or xy");
      if (chosen[k] && !(upper[k] > lower[k]))
        return setup.refuse("upper is not above lower on a periodic axis; give a positive length");
      if (chosen[k] && (setup.lower(k) + setup.upper(k) < 2 * lower[k] - (upper[k] - lower[k]) ||
                        setup.lower(k) + setup.upper(k) > 2 * upper[k] + (upper[k] - lower[k])))
        return setup.refuse(
            "the bodies lie outside the periodic range; give lower and upper that enclose them");
    }
  }

  void describe(scree::BoundaryLayout& layout) const {
    layout.still = true;
    for (std::size_t k = 0; k < 3; ++k)
      if (chosen[k]) layout.periodic[k] = {lower[k], upper[k]};
  }
};

}  // namespace

SCREE_BOUNDARY_PLUGIN(Periodic)
