#include "assembly/held_bodies.hpp"

namespace scree::response {

std::vector<bool> held_bodies(const std::vector<ContactTerms>& contacts, std::size_t bodies, int dimension,
                              int fewest_contacts) {
  std::vector<bool> held(bodies, true), tangential(bodies, false);
  const auto counts = [&](const ContactTerms& c) { return held[c.a] && (c.b >= bodies || held[c.b]); };
  for (bool changed = true; changed;) {
    changed = false;
    std::vector<int> number(bodies, 0);
    tangential.assign(bodies, false);
    for (const ContactTerms& c : contacts) {
      if (!counts(c)) continue;
      for (const std::uint32_t end : {c.a, c.b}) {
        if (end >= bodies) continue;
        ++number[end];
        if (c.tangential) tangential[end] = true;
      }
    }
    for (std::size_t i = 0; i < bodies; ++i) {
      const int needed = fewest_contacts > 0 ? fewest_contacts : tangential[i] ? 2 : dimension + 1;
      if (!held[i] || number[i] >= needed) continue;
      held[i] = false;
      changed = true;
    }
  }
  return held;
}

}  // namespace scree::response
