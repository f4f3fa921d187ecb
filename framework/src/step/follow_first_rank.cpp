#include "ranks/rank_commands.hpp"
#include "state/scene_message.hpp"
#include "state/state_bytes.hpp"
#include "step/simulation_parts.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <utility>

#include <scree/error.hpp>
#include <scree/follow_first_rank.hpp>
#include <scree/probes.hpp>
#include <scree/scene_record.hpp>
#include <scree/simulation.hpp>
#include <scree/state_hash.hpp>
#include <scree/state_transfer.hpp>

namespace scree {

namespace {

using Lines = std::vector<std::string>;

// The first rank has ended the simulation while it was in a step.
struct Ended {};

State received_state(Ranks& ranks) {
  std::uint64_t size = 0;
  ranks.broadcast(std::as_writable_bytes(std::span(&size, 1)));
  std::vector<std::byte> bytes(size);
  ranks.broadcast(bytes);
  return state_of(bytes);
}

// New parameters of a law, boundary or body force.
struct Change {
  std::string name;
  Lines going_on;
  Parameters parameters;
};

template <class Entries>
Change change_of(const Entries& entries, const Lines& lines) {
  const auto entry = std::find_if(entries.begin(), entries.end(),
                                  [&](const auto& candidate) { return candidate.name == lines[0]; });
  const auto first = lines.begin() + 2, own = first + std::stol(lines[1]);
  return {lines[0], {first, own}, parameters_of(entry->parameters.plugin(), {own, lines.end()})};
}

}  // namespace

// One simulation on a rank that follows.
class Follower {
 public:
  Follower(Scene scene, const BodyFacts& bodies, Ranks& ranks, PluginHost& host,
           const std::function<bool()>& is_interrupted)
      : ranks_(ranks), host_(host), simulation_(std::make_unique<SimulationParts>(std::move(scene), bodies)) {
    const State shared = received_state(ranks);
    parts_.share_with(ranks);
    parts_.transfer_shared(StateTransfer::restoring_from(shared));
    parts_.share->is_interrupted = is_interrupted;
    parts_.deal_tiles(parts_.balanced_owners(1));
  }

  // Does what the first rank commands, until a command comes; false if the simulation ends before.
  bool follow(RankCommand until) {
    for (;;) {
      const ReceivedCommand received = receive_command(ranks_);
      if (received.command == until) return true;
      if (received.command == RankCommand::end) return false;
      try {
        obey(received.command, received.lines);
      } catch (const Ended&) {
        return false;
      } catch (const SharedFailure&) {
        // The first rank reports it.
      }
    }
  }

 private:
  void obey(RankCommand command, const Lines& lines) {
    switch (command) {
      case RankCommand::step_observed:
        return void(parts_.stepper.step(Stepper::Next::observed));
      case RankCommand::step_followed:
        return void(parts_.stepper.step(Stepper::Next::follows));
      case RankCommand::step_by_substeps:
        return step_by_substeps();
      case RankCommand::find_and_evaluate_pairs:
        return parts_.find_and_evaluate_pairs();
      case RankCommand::gather_bodies:
        return parts_.gather_bodies();
      case RankCommand::gather_listed:
        return parts_.gather_listed({});
      case RankCommand::gather_pairs:
        return parts_.gather_pairs();
      case RankCommand::gather_sliding_work:
        return parts_.gather_sliding_work();
      case RankCommand::sum_energies:
        return void(simulation_.energy());
      case RankCommand::count_pairs:
        return void(parts_.count_pairs());
      case RankCommand::add_histories:
        return add_histories();
      case RankCommand::add_totals:
        return void(simulation_.totals_of(probe_of(lines)));
      default:
        return as_first_rank([&] { change(command, lines); });
    }
  }

  void add_histories() {
    StateHash of_nothing;
    parts_.add_histories(of_nothing);
  }

  // The probe of a number, of which more is said the first time.
  const Probe& probe_of(const Lines& lines) {
    if (lines.size() > 1) {
      std::uint64_t size = 0;
      ranks_.broadcast(std::as_writable_bytes(std::span(&size, 1)));
      std::vector<std::uint8_t> left_out(size);
      ranks_.broadcast(std::as_writable_bytes(std::span(left_out)));
      const scree_plugin& plugin = host_.find(lines[1], SCREE_PROBE);
      probes_.emplace(lines[0], Probe(parameters_of(plugin, {lines.begin() + 2, lines.end()}),
                                      simulation_.dimension(), std::move(left_out)));
    }
    return probes_.at(lines[0]);
  }

  void step_by_substeps() {
    const std::function<void(double)> wait = [this](double) {
      if (!follow(RankCommand::go_on)) throw Ended();
    };
    parts_.stepper.step(Stepper::Next::observed, &wait);
  }

  void change(RankCommand command, const Lines& lines) {
    const Scene& scene = simulation_.scene();
    if (command == RankCommand::change_law) {
      const Change c = change_of(scene.laws, lines);
      simulation_.reconfigure_law(c.name, c.parameters);
    } else if (command == RankCommand::change_boundary) {
      const Change c = change_of(scene.boundaries, lines);
      simulation_.reconfigure_boundary(c.name, c.parameters, c.going_on);
    } else if (command == RankCommand::change_body_force) {
      const Change c = change_of(scene.body_forces, lines);
      simulation_.reconfigure_body_force(c.name, c.parameters, c.going_on);
    } else {
      simulation_.apply_reconfiguration();
    }
  }

  // A change that is refused is refused on all ranks.
  template <class Action>
  static void as_first_rank(const Action& action) {
    try {
      action();
    } catch (const Error&) {
      // The first rank reports it.
    }
  }

  Ranks& ranks_;
  PluginHost& host_;
  std::map<std::string, Probe> probes_;  // by number on the first rank
  Simulation simulation_;
  SimulationParts& parts_ = *simulation_.parts_;
};

Simulation::Simulation(std::unique_ptr<SimulationParts> parts) : parts_(std::move(parts)) {}

void follow_first_rank(Ranks& ranks, PluginHost& host, unsigned threads,
                       const std::function<bool()>& is_interrupted) {
  for (;;) {
    const ReceivedCommand received = receive_command(ranks);
    if (received.command == RankCommand::leave) return;
    const State message = received_state(ranks);
    Scene scene = scene_of(message, host);
    scene.threads = threads;
    Follower(std::move(scene), facts_in(message), ranks, host, is_interrupted).follow(RankCommand::end);
  }
}

}  // namespace scree
