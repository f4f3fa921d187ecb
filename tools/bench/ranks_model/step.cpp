// Steps of a scene over ranks, as messages and computing times: no body is stored. To be run by the simulator
// of MPI that smpicxx belongs to, see `table`.
//
// Usage: step MESSAGES STEPS BODY_NS PAIR_NS SENT_NS RECEIVED_NS ADDED_NS VOTE_BYTES BEFORE UNEVENNESS
//
// MESSAGES: as lattice prints them. BODY_NS, PAIR_NS: computing time of a body and of a pair; SENT_NS,
// RECEIVED_NS: of copying a record that is sent or received; ADDED_NS: of adding a received load. BEFORE:
// share of the pairs inside tiles that are evaluated before a rank waits for records; as many before it waits
// for loads, and the rest between. Below 0: it waits for each at once, as where messages make no progress
// during computation. UNEVENNESS: standard deviation of the computing time of a step, relative.

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <mpi.h>
#include <random>
#include <smpi/smpi.h>
#include <vector>

namespace {

constexpr int record_bytes = 120, load_bytes = 48;
constexpr double sum_ns = 0.5;  // adding a number of the vote to another

struct Costs {
  double body, pair, sent, received, added;  // (s)
};

struct Partner {
  int rank, records, loads;
};

struct Share {
  double bodies = 0, inner = 0, cross = 0;
  std::vector<Partner> partners;
};

Share read(const char* path, int rank) {
  std::ifstream file(path);
  for (int line = 0; line < rank; ++line) file.ignore(std::numeric_limits<std::streamsize>::max(), '\n');
  Share share;
  file >> share.bodies >> share.inner >> share.cross;
  while (file.peek() == ' ') {
    Partner partner{};
    file >> partner.rank >> partner.records >> partner.loads;
    share.partners.push_back(partner);
  }
  return share;
}

// Adds up in whatever order, as exact sums may be.
void add_up(void*, void*, int* numbers, MPI_Datatype*) { smpi_execute(1e-9 * sum_ns * *numbers); }

class Rank {
 public:
  enum Phase { computing, copying, records, loads, voting, phases };

  Rank(const Share& share, const Costs& costs, int vote_bytes)
      : share_(share), costs_(costs), vote_(vote_bytes / sizeof(std::int64_t)), votes_(vote_.size()) {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    int most = 0;
    for (const Partner& partner : share_.partners)
      most = std::max({most, record_bytes * partner.records, load_bytes * partner.loads});
    sent_.resize(std::size_t(most)), received_.resize(std::size_t(most));
    MPI_Op_create(add_up, true, &sum_);
  }

  void step(double before, double slowness) {
    copy(costs_.sent * number(&Partner::records, true));
    exchange(true);
    if (before >= 0) compute(slowness * before * costs_.pair * share_.inner);
    wait(records);
    copy(costs_.received * number(&Partner::records, false));
    const double between = before < 0 ? 0 : 1 - 2 * before;
    compute(slowness * costs_.pair * (share_.cross + between * share_.inner));
    exchange(false);
    if (before >= 0) compute(slowness * before * costs_.pair * share_.inner);
    wait(loads);
    copy(costs_.added * number(&Partner::loads, true));
    if (before < 0) compute(slowness * costs_.pair * share_.inner);
    compute(slowness * costs_.body * share_.bodies);
    vote();
  }

  void vote() {
    MPI_Allreduce(vote_.data(), votes_.data(), int(vote_.size()), MPI_INT64_T, sum_, MPI_COMM_WORLD);
    finish(voting);
  }

  void start() {
    times_ = {};
    at_ = MPI_Wtime();
  }
  const std::array<double, phases>& times() const { return times_; }

 private:
  // Of what is exchanged with lower ranks, or with higher ones.
  double number(int Partner::*what, bool lower) const {
    double sum = 0;
    for (const Partner& partner : share_.partners)
      if ((partner.rank < rank_) == lower) sum += partner.*what;
    return sum;
  }

  // Records to lower ranks, or loads to higher ones. What arrives is not read, so that one buffer is enough.
  void exchange(bool of_records) {
    for (const Partner& partner : share_.partners) {
      const int bytes = of_records ? record_bytes * partner.records : load_bytes * partner.loads;
      MPI_Request& request = requests_.emplace_back();
      if ((partner.rank < rank_) == of_records) {
        MPI_Isend(sent_.data(), bytes, MPI_BYTE, partner.rank, of_records, MPI_COMM_WORLD, &request);
      } else {
        MPI_Irecv(received_.data(), bytes, MPI_BYTE, partner.rank, of_records, MPI_COMM_WORLD, &request);
      }
    }
    finish(copying);
  }
  void wait(Phase phase) {
    MPI_Waitall(int(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE);
    requests_.clear();
    finish(phase);
  }
  void compute(double seconds) {
    smpi_execute(seconds);
    finish(computing);
  }
  void copy(double seconds) {
    smpi_execute(seconds);
    finish(copying);
  }
  void finish(Phase phase) {
    const double now = MPI_Wtime();
    times_[phase] += now - at_;
    at_ = now;
  }

  Share share_;
  Costs costs_;
  int rank_ = 0;
  MPI_Op sum_;
  std::vector<std::int64_t> vote_, votes_;
  std::vector<char> sent_, received_;
  std::vector<MPI_Request> requests_;
  std::array<double, phases> times_{};
  double at_ = 0;
};

// Prints (us) the mean over ranks and steps of each phase, whose sum is a step; of the ranks the longest wait
// for records and for loads; the vote of ranks that begin it together.
void run(Rank& rank, int steps, double before, double unevenness) {
  int id = 0, ranks = 1;
  MPI_Comm_rank(MPI_COMM_WORLD, &id);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::mt19937 random{std::uint32_t(id + 1)};
  std::normal_distribution<double> gauss;
  rank.step(before, 1);  // ranks begin in step with each other, and algorithms have set up what they keep
  rank.start();
  for (int k = 0; k < steps; ++k) rank.step(before, 1 + unevenness * gauss(random));
  const double* own = rank.times().data();
  std::array<double, Rank::phases> all{}, most{};
  MPI_Reduce(own, all.data(), Rank::phases, MPI_DOUBLE, MPI_SUM, 0, MPI_COMM_WORLD);
  MPI_Reduce(own, most.data(), Rank::phases, MPI_DOUBLE, MPI_MAX, 0, MPI_COMM_WORLD);
  MPI_Barrier(MPI_COMM_WORLD);
  rank.start();
  rank.vote();
  if (id != 0) return;
  for (const double time : all) std::printf("%.3f ", 1e6 * time / ranks / steps);
  for (const int phase : {Rank::records, Rank::loads}) std::printf("%.3f ", 1e6 * most[phase] / steps);
  std::printf("%.3f\n", 1e6 * rank.times()[Rank::voting]);
}

}  // namespace

int main(int count, char** words) {
  MPI_Init(&count, &words);
  if (count == 11) {
    int id = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &id);
    std::array<double, 9> value;
    for (int k = 0; k < 9; ++k) value[std::size_t(k)] = std::atof(words[k + 2]);
    const Costs costs{1e-9 * value[1], 1e-9 * value[2], 1e-9 * value[3], 1e-9 * value[4], 1e-9 * value[5]};
    Rank rank(read(words[1], id), costs, int(value[6]));
    run(rank, int(value[0]), value[7], value[8]);
  }
  MPI_Finalize();
  return count == 11 ? 0 : 2;
}
