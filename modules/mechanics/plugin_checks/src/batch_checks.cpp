#include "law_under_check.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

// Checks of single batches, without a simulation.

namespace scree::plugin_checks {

namespace {

using Verdict = Check::Verdict;

// All outputs that a law writes, and its history.
std::vector<double> everything(const LawUnderCheck& law, const ContactColumns& contacts, std::size_t i) {
  std::vector<double> all;
  for (int k = 0; k < law.dimension; ++k) all.push_back(contacts.output(SCREE_FORCE, k, i));
  for (int k = 0; law.has_couple() && k < law.spins(); ++k)
    all.push_back(contacts.output(SCREE_COUPLE, k, i));
  for (int k = SCREE_ELASTIC_NORMAL; k < SCREE_CONTACT_OUTPUT_COUNT; ++k)
    all.push_back(contacts.output(scree_contact_output(k), 0, i));
  for (std::uint32_t k = 0; k < law.law.instance().history_width; ++k) all.push_back(contacts.history(k, i));
  return all;
}

// Largest difference of force and couple from those in another frame, over the largest force.
double deviation(const LawUnderCheck& law, const Frame& frame) {
  ContactColumns here(LawUnderCheck::variants), there(LawUnderCheck::variants);
  std::vector<std::vector<Vec3>> forces, couples;
  law.follow(here, {}, 0, [&](int) {
    auto& f = forces.emplace_back();
    auto& c = couples.emplace_back();
    for (std::size_t i = 0; i < here.size(); ++i) {
      f.push_back(here.output_vector(SCREE_FORCE, i));
      c.push_back(law.has_couple() ? here.output_vector(SCREE_COUPLE, i) : Vec3{});
    }
  });
  const double sign = frame.exchanged ? -1 : 1;
  const auto turned_couple = [&](const Vec3& c) { return law.dimension == 2 ? sign * c : sign * frame(c); };
  double largest_force = 0, largest_couple = 0, force = 0, couple = 0;
  law.follow(there, frame, 0, [&](int step) {
    for (std::size_t i = 0; i < there.size(); ++i) {
      const Vec3 f = forces[std::size_t(step)][i], c = couples[std::size_t(step)][i];
      largest_force = std::max(largest_force, norm(f));
      largest_couple = std::max(largest_couple, norm(c));
      force = std::max(force, norm(there.output_vector(SCREE_FORCE, i) - sign * frame(f)));
      if (law.has_couple())
        couple = std::max(couple, norm(there.output_vector(SCREE_COUPLE, i) - turned_couple(c)));
    }
  });
  return std::max(largest_force > 0 ? force / largest_force : 0,
                  largest_couple > 0 ? couple / largest_couple : 0);
}

}  // namespace

// Round-off of some 10³ operations, amplified where a spring begins to slide.
Checks check_symmetries(const LawUnderCheck& law) {
  constexpr double bound = 1e-9;
  const Frame exchanged{.exchanged = true};
  Frame rotated{.angle = 1.1};
  if (law.dimension == 3) rotated.axis = {{0.48, 0.64, 0.6}};
  return {bounded("force and couple change sign when the bodies change their names",
                  deviation(law, exchanged), bound),
          bounded("force and couple rotate with the contact", deviation(law, rotated), bound)};
}

// Bodies of a law without `tangential` carry no spin, so that such a force would create angular momentum.
Checks check_direction(const LawUnderCheck& law) {
  const std::string name = "forces are along the normal, or `tangential` is declared";
  if (law.law.instance().tangential) return {{name, Verdict::passed, "it is declared"}};
  ContactColumns contacts(LawUnderCheck::variants);
  double across = 0, largest = 0;
  law.follow(contacts, {}, 0, [&](int) {
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Vec3 force = contacts.output_vector(SCREE_FORCE, i);
      Vec3 normal;
      for (int k = 0; k < 3; ++k) normal[k] = contacts.input(SCREE_NORMAL, k, i);
      across = std::max(across, norm(tangential_part(force, normal)));
      largest = std::max(largest, norm(force));
    }
  });
  return {bounded(name, largest > 0 ? across / largest : 0, 1e-12)};
}

Checks check_parting(const LawUnderCheck& law) {
  ContactColumns contacts(LawUnderCheck::variants);
  double apart = 0, history = 0;
  law.follow(contacts, {}, 0, [&](int step) {
    for (std::size_t i = 0; step >= Passage::steps_touching && i < contacts.size(); ++i) {
      for (std::uint32_t k = 0; k < law.law.instance().history_width; ++k)
        history = std::max(history, std::abs(contacts.history(k, i)));
      const std::vector<double> all = everything(law, contacts, i);
      // Springs may release their energy in the first step apart.
      const std::size_t release = all.size() - law.law.instance().history_width - 1;
      for (std::size_t k = 0; k < all.size(); ++k)
        if (k != release || step > Passage::steps_touching) apart = std::max(apart, std::abs(all[k]));
    }
  });
  return {bounded("no force, couple or energy between bodies that are apart", apart, 0),
          bounded("the history is 0 after parting", history, 0)};
}

Checks check_batches(const LawUnderCheck& law) {
  ContactColumns together(LawUnderCheck::variants);
  std::vector<std::vector<double>> expected;
  law.follow(together, {}, 0, [&](int) {
    for (std::size_t i = 0; i < together.size(); ++i) expected.push_back(everything(law, together, i));
  });
  std::size_t different = 0;
  for (int variant = 0; variant < LawUnderCheck::variants; ++variant) {
    ContactColumns alone(1);
    law.follow(alone, {}, variant, [&](int step) {
      different +=
          everything(law, alone, 0) != expected[std::size_t(step * LawUnderCheck::variants + variant)];
    });
  }
  const bool same = different == 0;
  return {{"the same bits alone and in a batch", same ? Verdict::passed : Verdict::failed,
           fmt::format("{} of {} contacts differ", different, expected.size())}};
}

}  // namespace scree::plugin_checks
