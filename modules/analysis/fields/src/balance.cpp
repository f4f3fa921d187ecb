#include <algorithm>
#include <cmath>

#include <scree/error.hpp>
#include <scree/fields/balance.hpp>
#include <scree/fields/field_sums.hpp>

namespace scree::fields {

namespace {

constexpr std::size_t balance_slabs_per_thread = 4;

double largest_of(const Vec3& v) { return std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}); }

void check_pair(const FieldInput& first, const FieldInput& second, const FieldGrid& grid) {
  check_input(grid, first);
  check_input(grid, second);
  const auto same_id = [](const FieldBody& a, const FieldBody& b) { return a.id == b.id; };
  if (first.bodies.size() != second.bodies.size() ||
      !std::equal(first.bodies.begin(), first.bodies.end(), second.bodies.begin(), same_id))
    throw Error("", "the states have different bodies", "give states of one run");
}

// Adds terms at the points of one slab.
class Terms {
 public:
  Terms(const FieldGrid& grid, const AveragingKernel& kernel, const GridSlab& slab,
        std::vector<Vec3>& residual)
      : grid_(grid), kernel_(kernel), slab_(slab), residual_(residual) {}

  // amount φ(x − place)
  void add_at(const Vec3& place, const Vec3& amount) {
    const double largest = largest_of(amount);
    if (!(largest > 0)) return;
    grid_.each_near(place, {}, kernel_.width(), slab_, [&](std::size_t number, const Vec3& offset) {
      const double weight = kernel_(dot(offset, offset));
      residual_[number] += weight * amount;
      largest_ = std::max(largest_, weight * largest);
    });
  }
  // ∇·(amount ⊗ line ∫φ(x − start − s line) ds)
  void add_along(const Vec3& start, const Vec3& line, const Vec3& amount) {
    const double largest = largest_of(amount);
    if (!(largest > 0)) return;
    grid_.each_near(start, line, kernel_.width(), slab_, [&](std::size_t number, const Vec3& offset) {
      const double drop = kernel_.along(offset, line).drop;
      residual_[number] += drop * amount;
      largest_ = std::max(largest_, std::abs(drop) * largest);
    });
  }
  double largest() const { return largest_; }

 private:
  const FieldGrid& grid_;
  const AveragingKernel& kernel_;
  const GridSlab slab_;
  std::vector<Vec3>& residual_;
  double largest_ = 0;
};

template <class AddTerms>
Balance balance_of(const FieldGrid& grid, const AveragingKernel& kernel, ThreadPool& threads,
                   const AddTerms& add_terms) {
  Balance balance;
  balance.residual.resize(grid.size());
  const std::size_t slabs = threads.size() == 1 ? 1 : balance_slabs_per_thread * threads.size();
  std::vector<double> largest(slabs, 0.0);
  threads.each(slabs, [&](std::size_t part, unsigned) {
    const GridSlab slab = grid.slab(part, slabs);
    if (slab.begin == slab.end) return;
    Terms terms(grid, kernel, slab, balance.residual);
    add_terms(terms);
    largest[part] = terms.largest();
  });
  balance.largest_term = *std::max_element(largest.begin(), largest.end());
  return balance;
}

// Impulse (N s) of what no contact exerts, at the place of the body.
Vec3 outer_impulse(const FieldBody& before, const FieldBody& after, double step) {
  Vec3 impulse = 0.5 * step * (before.body_force + after.body_force + before.group_load + after.group_load);
  for (int k = 0; k < 3; ++k)
    if (after.is_held(k))
      impulse[k] += after.mass * (after.velocity[k] - before.velocity[k]) -
                    0.5 * step * (before.force[k] + after.force[k]);
  return impulse;
}

void add_body_terms(const FieldBody& before, const FieldBody& after, double step, const Domain& domain,
                    Terms& terms) {
  const double mass = after.mass;
  terms.add_at(after.position, mass * after.velocity);
  terms.add_at(before.position, -(mass * before.velocity));
  terms.add_along(before.position, path_between(before, after, domain),
                  0.5 * mass * (before.velocity + after.velocity));
  const Vec3 half_impulse = 0.5 * outer_impulse(before, after, step);
  terms.add_at(before.position, -half_impulse);
  terms.add_at(after.position, -half_impulse);
}

// Half of the impulse of a contact of `here`, along its line there and along that of the same bodies at the
// other time; a point of a wall goes with the body that touches it.
void add_contact_terms(const FieldContact& contact, const FieldInput& here, const FieldInput& there,
                       double step, Terms& terms) {
  const FieldBody &a = here.bodies[contact.a], &other_a = there.bodies[contact.a];
  const bool wall = contact.b == FieldContact::wall;
  Vec3 other_line = contact.line;
  if (!wall)
    other_line += path_between(a, other_a, here.domain) -
                  path_between(here.bodies[contact.b], there.bodies[contact.b], here.domain);
  const Vec3 share = 0.25 * step * contact.force;
  const Vec3 start = a.position - contact.line, other_start = other_a.position - other_line;
  terms.add_along(start, contact.line, share);
  terms.add_along(other_start, other_line, share);
  if (!wall) return;
  terms.add_at(start, -share);
  terms.add_at(other_start, -share);
}

}  // namespace

Vec3 path_between(const FieldBody& from, const FieldBody& to, const Domain& domain) {
  Vec3 path = to.position - from.position;
  for (int k = 0; k < 3; ++k)
    if (domain.periodic[std::size_t(k)])
      path[k] += double(to.image[std::size_t(k)] - from.image[std::size_t(k)]) * domain.length(k);
  return path;
}

double Balance::relative() const {
  double most = 0;
  for (const Vec3& r : residual) most = std::max(most, largest_of(r));
  return largest_term > 0 ? most / largest_term : 0;
}

Balance mass_balance(const FieldInput& first, const FieldInput& second, const FieldGrid& grid,
                     const AveragingKernel& kernel, ThreadPool& threads) {
  check_pair(first, second, grid);
  return balance_of(grid, kernel, threads, [&](Terms& terms) {
    for (std::size_t i = 0; i < first.bodies.size(); ++i) {
      const FieldBody &before = first.bodies[i], &after = second.bodies[i];
      terms.add_at(after.position, {{after.mass, 0, 0}});
      terms.add_at(before.position, {{-before.mass, 0, 0}});
      terms.add_along(before.position, path_between(before, after, first.domain), {{after.mass, 0, 0}});
    }
  });
}

Balance momentum_balance(const FieldInput& first, const FieldInput& second, double step,
                         const FieldGrid& grid, const AveragingKernel& kernel, ThreadPool& threads) {
  check_pair(first, second, grid);
  return balance_of(grid, kernel, threads, [&](Terms& terms) {
    for (std::size_t i = 0; i < first.bodies.size(); ++i)
      add_body_terms(first.bodies[i], second.bodies[i], step, first.domain, terms);
    for (const FieldContact& contact : first.contacts) add_contact_terms(contact, first, second, step, terms);
    for (const FieldContact& contact : second.contacts)
      add_contact_terms(contact, second, first, step, terms);
  });
}

}  // namespace scree::fields
