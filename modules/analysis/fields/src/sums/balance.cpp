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

// Impulse (N s) of what no contact exerts on body i, at the place of the body.
Vec3 outer_impulse(std::size_t i, const FieldBody& before, const FieldBody& after,
                   std::span<const ForceShare> forces) {
  Vec3 impulse = {}, all = {};
  for (const ForceShare& share : forces) {
    const FieldBody& body = share.input->bodies[i];
    impulse += share.duration * (body.body_force + body.group_load);
    all += share.duration * body.force;
  }
  for (int k = 0; k < 3; ++k)
    if (after.is_held(k)) impulse[k] += after.mass * (after.velocity[k] - before.velocity[k]) - all[k];
  return impulse;
}

void add_body_terms(const FieldBody& before, const FieldBody& after, const Vec3& impulse,
                    const Domain& domain, Terms& terms) {
  const double mass = after.mass;
  terms.add_at(after.position, mass * after.velocity);
  terms.add_at(before.position, -(mass * before.velocity));
  terms.add_along(before.position, path_between(before, after, domain),
                  0.5 * mass * (before.velocity + after.velocity));
  terms.add_at(before.position, -(0.5 * impulse));
  terms.add_at(after.position, -(0.5 * impulse));
}

// An impulse (N s) of a contact that is listed at the time `here`, along the line of the same bodies at
// another time; a point of a wall goes with the body that touches it.
void add_contact_terms(const FieldContact& contact, const Vec3& impulse, const FieldInput& here,
                       const FieldInput& there, Terms& terms) {
  const FieldBody &a = here.bodies[contact.a], &there_a = there.bodies[contact.a];
  const bool wall = contact.b == FieldContact::wall;
  Vec3 line = contact.line;
  if (!wall)
    line += path_between(a, there_a, here.domain) -
            path_between(here.bodies[contact.b], there.bodies[contact.b], here.domain);
  const Vec3 start = there_a.position - line;
  terms.add_along(start, line, impulse);
  if (wall) terms.add_at(start, -impulse);
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

std::vector<ForceShare> verlet_shares(const FieldInput& before, const FieldInput& after, double step) {
  return {{&before, 0.5 * step}, {&after, 0.5 * step}};
}

std::vector<ForceShare> adams_moulton_shares(std::span<const FieldInput> last, double step) {
  static constexpr double weights[] = {1.0 / 24, -5.0 / 24, 19.0 / 24, 9.0 / 24};
  std::vector<ForceShare> shares;
  for (std::size_t k = 0; k < 4; ++k) shares.push_back({&last[last.size() - 4 + k], weights[k] * step});
  return shares;
}

Balance momentum_balance(const FieldInput& first, const FieldInput& second,
                         std::span<const ForceShare> forces, const FieldGrid& grid,
                         const AveragingKernel& kernel, ThreadPool& threads) {
  check_pair(first, second, grid);
  for (const ForceShare& share : forces) check_pair(first, *share.input, grid);
  return balance_of(grid, kernel, threads, [&](Terms& terms) {
    for (std::size_t i = 0; i < first.bodies.size(); ++i) {
      const FieldBody &before = first.bodies[i], &after = second.bodies[i];
      add_body_terms(before, after, outer_impulse(i, before, after, forces), first.domain, terms);
    }
    for (const ForceShare& share : forces)
      for (const FieldContact& contact : share.input->contacts)
        for (const FieldInput* end : {&first, &second})
          add_contact_terms(contact, 0.5 * share.duration * contact.force, *share.input, *end, terms);
  });
}

void Balance::add(const Balance& next) {
  residual.resize(next.residual.size());
  for (std::size_t k = 0; k < residual.size(); ++k) residual[k] += next.residual[k];
  largest_term = std::max(largest_term, next.largest_term);
}

}  // namespace scree::fields
