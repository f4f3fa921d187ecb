#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/ranks/join_ranks.hpp>

using namespace scree;

TEST_CASE("a program without MPI says what to install", "[join_ranks]") {
  if (ranks::has_mpi()) return;  // mpi_test.sh joins
  try {
    ranks::join_ranks();
    FAIL("joined without MPI");
  } catch (const Error& error) {
    CHECK(error.status() == ExitStatus::failure);
    CHECK(std::string(error.what()) ==
          "this program was built without MPI, which is required for several processes; install "
          "libopenmpi-dev, configure and build again");
  }
}
