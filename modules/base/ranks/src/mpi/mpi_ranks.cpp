#include "backend.hpp"
#include "metis_partition.hpp"
#include "pieces.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <cstring>
#include <exception>
#include <limits>
#include <mpi.h>
#include <string>
#include <thread>

#include <fmt/format.h>

#include <scree/error.hpp>

namespace scree::ranks {
namespace {

void check(int status, const char* action) {
  if (status == MPI_SUCCESS) return;
  std::array<char, MPI_MAX_ERROR_STRING> text = {};
  int length = 0;
  MPI_Error_string(status, text.data(), &length);
  std::string line(text.data(), std::size_t(length));
  std::replace(line.begin(), line.end(), '\n', ' ');
  throw Error("MPI", fmt::format("cannot {} ({})", action, line), "see what mpirun has written about it",
              ExitStatus::failure);
}

// From MPI_Init to MPI_Finalize.
class Membership {
 public:
  Membership() {
    int initialised = 0, threads = 0;
    check(MPI_Initialized(&initialised), "ask whether it is in use");
    if (initialised) throw Error("MPI", "is joined a second time", "join it once", ExitStatus::failure);
    check(MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &threads), "start");
    check(MPI_Comm_set_errhandler(MPI_COMM_WORLD, MPI_ERRORS_RETURN), "start");
    check(MPI_Comm_dup(MPI_COMM_WORLD, &ranks), "start");
    check(MPI_Comm_dup(MPI_COMM_WORLD, &leaving_), "start");
    if (threads < MPI_THREAD_FUNNELED)
      throw Error("MPI", "does not allow threads", "use an MPI that was built with threads",
                  ExitStatus::failure);
  }
  Membership(const Membership&) = delete;
  Membership& operator=(const Membership&) = delete;

  // MPI must not be called again while messages are under way, whose memory may be gone.
  ~Membership() {
    if (!begun.empty() || !exchanged.empty()) return;
    const bool all_leave = others_leave();
    if (all_leave || std::uncaught_exceptions() == exceptions_) MPI_Finalize();
  }

  MPI_Comm ranks = MPI_COMM_NULL;  // with the error handler of the world
  std::vector<MPI_Request> begun, exchanged;

 private:
  // Whether all ranks are about to leave, within some seconds.
  bool others_leave() {
    if (leaving_ == MPI_COMM_NULL) return false;
    MPI_Request all_leave;
    if (MPI_Ibarrier(leaving_, &all_leave) != MPI_SUCCESS) return false;
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(5);
    for (int done = 0; std::chrono::steady_clock::now() < end;) {
      if (MPI_Test(&all_leave, &done, MPI_STATUS_IGNORE) != MPI_SUCCESS) return false;
      if (done) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return false;
  }

  MPI_Comm leaving_ = MPI_COMM_NULL;
  int exceptions_ = std::uncaught_exceptions();
};

// One element of a reduction: with a number and a count in each, MPI reduces both at once and may split the
// elements among ranks.
struct NumberAndCount {
  double largest;
  std::int64_t sum;
};
static_assert(sizeof(NumberAndCount) == 16);

// The same bits in any order: of 0 and -0, 0.
double larger(double one, double other) {
  return one < other || (one == other && std::signbit(one)) ? other : one;
}

// Sums wrap around, since they may be bits of something else.
void combine_elements(void* from, void* into, int* count, MPI_Datatype*) {
  const auto* const source = static_cast<const NumberAndCount*>(from);
  auto* const target = static_cast<NumberAndCount*>(into);
  for (int k = 0; k < *count; ++k) {
    target[k].largest = larger(target[k].largest, source[k].largest);
    target[k].sum = std::int64_t(std::uint64_t(target[k].sum) + std::uint64_t(source[k].sum));
  }
}

class MpiRanks final : public Ranks {
 public:
  explicit MpiRanks(std::size_t piece) : piece_(piece) {
    int rank = 0, size = 0;
    check(MPI_Comm_rank(all_.ranks, &rank), "start");
    check(MPI_Comm_size(all_.ranks, &size), "start");
    rank_ = unsigned(rank), size_ = unsigned(size);
    check(MPI_Type_contiguous(int(sizeof(NumberAndCount)), MPI_BYTE, &element_), "start");
    check(MPI_Type_commit(&element_), "start");
    check(MPI_Op_create(combine_elements, 1, &combination_), "start");
  }

  unsigned rank() const override { return rank_; }
  unsigned size() const override { return size_; }

#if SCREE_METIS
  std::vector<std::uint32_t> partition(const TileGraph& graph) override {
    return metis_partition(graph, size_);
  }
#endif

  void broadcast(std::span<std::byte> data) override {
    each_piece(data, piece_, [&](std::span<std::byte> piece) {
      check(MPI_Bcast(piece.data(), int(piece.size()), MPI_BYTE, 0, all_.ranks), "broadcast");
    });
  }

  void combine(std::span<double> largest, std::span<std::int64_t> sums) override {
    elements_.assign(std::max(largest.size(), sums.size()), {-std::numeric_limits<double>::infinity(), 0});
    for (std::size_t k = 0; k < largest.size(); ++k) elements_[k].largest = largest[k];
    for (std::size_t k = 0; k < sums.size(); ++k) elements_[k].sum = sums[k];
    each_piece(std::span(elements_), piece_ / sizeof(NumberAndCount), [&](std::span<NumberAndCount> piece) {
      check(MPI_Allreduce(MPI_IN_PLACE, piece.data(), int(piece.size()), element_, combination_, all_.ranks),
            "combine numbers of all ranks");
    });
    for (std::size_t k = 0; k < largest.size(); ++k) largest[k] = elements_[k].largest;
    for (std::size_t k = 0; k < sums.size(); ++k) sums[k] = elements_[k].sum;
  }

  std::vector<Bytes> exchange(const std::vector<Bytes>& outgoing) override {
    std::vector<std::uint64_t> sizes(size_), sizes_here(size_);
    for (unsigned r = 0; r < size_; ++r) sizes[r] = outgoing.at(r).size();
    check(MPI_Alltoall(sizes.data(), 1, MPI_UINT64_T, sizes_here.data(), 1, MPI_UINT64_T, all_.ranks),
          "exchange lengths");
    std::vector<Bytes> incoming(size_);
    for (const unsigned r : others()) incoming[r].resize(sizes_here[r]);
    incoming[rank_] = outgoing[rank_];
    for (const unsigned r : others()) receive(r, incoming[r], all_.exchanged);
    for (const unsigned r : others()) send(r, outgoing[r], all_.exchanged);
    wait(all_.exchanged);
    return incoming;
  }

  void begin(std::span<const Sent> sent, std::span<const Received> received) override {
    for (const Received& message : received)
      receive(message.from, std::as_writable_bytes(message.numbers), all_.begun);
    for (const Sent& message : sent) send(message.to, std::as_bytes(message.numbers), all_.begun);
  }

  void finish() override { wait(all_.begun); }

 private:
  static constexpr int tag = 0;

  // From the next rank on, so that not all ranks send to the same one first.
  std::vector<unsigned> others() const {
    std::vector<unsigned> ranks;
    for (unsigned k = 1; k < size_; ++k) ranks.push_back((rank_ + k) % size_);
    return ranks;
  }

  // Between two ranks MPI keeps the order of messages with the same tag, so that neither pieces of a message
  // nor messages that are begun and exchanged are taken for one another.
  void receive(unsigned from, std::span<std::byte> data, std::vector<MPI_Request>& requests) {
    each_piece(data, piece_, [&](std::span<std::byte> piece) {
      check(MPI_Irecv(piece.data(), int(piece.size()), MPI_BYTE, int(from), tag, all_.ranks,
                      &requests.emplace_back(MPI_REQUEST_NULL)),
            "receive");
    });
  }
  void send(unsigned to, std::span<const std::byte> data, std::vector<MPI_Request>& requests) {
    each_piece(data, piece_, [&](std::span<const std::byte> piece) {
      check(MPI_Isend(piece.data(), int(piece.size()), MPI_BYTE, int(to), tag, all_.ranks,
                      &requests.emplace_back(MPI_REQUEST_NULL)),
            "send");
    });
  }
  static void wait(std::vector<MPI_Request>& requests) {
    std::vector<MPI_Status> statuses(requests.size());
    const int status = MPI_Waitall(int(requests.size()), requests.data(), statuses.data());
    if (status == MPI_ERR_IN_STATUS)
      for (const MPI_Status& message : statuses) check(message.MPI_ERROR, "send or receive a message");
    check(status, "wait for messages");
    requests.clear();
  }

  Membership all_;
  std::size_t piece_;
  unsigned rank_ = 0, size_ = 1;
  MPI_Datatype element_ = MPI_DATATYPE_NULL;
  MPI_Op combination_ = MPI_OP_NULL;
  std::vector<NumberAndCount> elements_;
};

class MpiBackend final : public RanksBackend {
 public:
  std::unique_ptr<Ranks> join(std::size_t piece) override { return std::make_unique<MpiRanks>(piece); }
};

}  // namespace
}  // namespace scree::ranks

// Returns null if the program was built against another version of the interface.
extern "C" __attribute__((visibility("default"))) scree::ranks::RanksBackend* scree_create_ranks_backend(
    int version) {
  return version == scree::ranks::backend_version ? new scree::ranks::MpiBackend : nullptr;
}
