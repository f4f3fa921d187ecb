#include "temporary_folder.hpp"

#include <sched.h>
#include <thread>

#include <catch2/catch.hpp>

#include <scree/allowed_processors.hpp>

using scree::processors_of_quota;
using scree::test::TemporaryFolder;

TEST_CASE("processors that the affinity excludes are not counted", "[machine]") {
  unsigned counted = 0;
  // In a thread of its own, as the affinity stays.
  std::thread([&counted] {
    cpu_set_t before, one;
    REQUIRE(sched_getaffinity(0, sizeof(before), &before) == 0);
    CPU_ZERO(&one);
    for (int k = 0; k < CPU_SETSIZE; ++k)
      if (CPU_ISSET(k, &before)) {
        CPU_SET(k, &one);
        break;
      }
    REQUIRE(sched_setaffinity(0, sizeof(one), &one) == 0);
    counted = scree::allowed_processors();
  }).join();
  CHECK(counted == 1);
  CHECK(scree::allowed_processors() >= 1);
}

TEST_CASE("a quota of processor time counts as processors, rounded up", "[machine]") {
  const TemporaryFolder root;
  std::filesystem::create_directories(root / "jobs/one");
  CHECK(processors_of_quota("0::/jobs/one\n", root.path()) == 0);
  root.write("jobs/one/cpu.max", "max 100000\n");
  CHECK(processors_of_quota("0::/jobs/one\n", root.path()) == 0);
  root.write("jobs/one/cpu.max", "350000 100000\n");
  CHECK(processors_of_quota("0::/jobs/one\n", root.path()) == 4);
  // That of a group above holds too, and a group of the host that the container does not show is passed over.
  root.write("jobs/cpu.max", "200000 100000\n");
  CHECK(processors_of_quota("0::/jobs/one\n", root.path()) == 2);
  CHECK(processors_of_quota("0::/jobs/of/the/host\n", root.path()) == 2);
}

TEST_CASE("quotas of control groups of version 1 are read too", "[machine]") {
  const TemporaryFolder root;
  std::filesystem::create_directories(root / "cpu,cpuacct/job");
  root.write("cpu,cpuacct/job/cpu.cfs_quota_us", "-1\n");
  root.write("cpu,cpuacct/job/cpu.cfs_period_us", "100000\n");
  const char* groups = "5:memory:/job\n4:cpu,cpuacct:/job\n0::/job\n";
  CHECK(processors_of_quota(groups, root.path()) == 0);
  root.write("cpu,cpuacct/job/cpu.cfs_quota_us", "150000\n");
  CHECK(processors_of_quota(groups, root.path()) == 2);
  CHECK(processors_of_quota("5:memory:/job\n", root.path()) == 0);
}
