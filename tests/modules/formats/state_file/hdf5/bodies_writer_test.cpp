#include "sample_state.hpp"
#include "temporary_folder.hpp"

#include <array>
#include <hdf5.h>

#include <catch2/catch.hpp>

#include <scree/state_file/state_file.hpp>

// What other programs find: H5MD 1.1, read by the functions of HDF5 alone.

using namespace scree;
using namespace scree::test;

namespace {

struct File {
  TemporaryFolder folder;
  hid_t id = -1;

  explicit File(const State& state) {
    state_file::write_state(folder / "a.h5", state);
    id = H5Fopen((folder / "a.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  }
  ~File() { H5Fclose(id); }

  bool has(const char* path) const { return H5Oexists_by_name(id, path, H5P_DEFAULT) > 0; }

  template <class T>
  std::vector<T> values(const char* path, hid_t type, std::vector<hsize_t> expected_shape) const {
    const hid_t dataset = H5Dopen2(id, path, H5P_DEFAULT), space = H5Dget_space(dataset);
    std::vector<hsize_t> shape(std::size_t(H5Sget_simple_extent_ndims(space)));
    H5Sget_simple_extent_dims(space, shape.data(), nullptr);
    CHECK(shape == expected_shape);
    std::vector<T> values(std::size_t(H5Sget_simple_extent_npoints(space)));
    CHECK(H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0);
    H5Dclose(dataset), H5Sclose(space);
    return values;
  }
  // Texts of an attribute, each of so many bytes; filled with 0.
  std::string attribute(const char* object, const char* name, std::size_t bytes) const {
    const hid_t attribute = H5Aopen_by_name(id, object, name, H5P_DEFAULT, H5P_DEFAULT),
                type = H5Aget_type(attribute);
    REQUIRE(H5Tis_variable_str(type) == 0);
    CHECK(H5Tget_size(type) == bytes);
    std::string text(std::size_t(H5Aget_storage_size(attribute)), ' ');
    H5Aread(attribute, type, text.data());
    H5Aclose(attribute), H5Tclose(type);
    return text;
  }
  std::vector<int> integers(const char* object, const char* name, std::size_t count) const {
    const hid_t attribute = H5Aopen_by_name(id, object, name, H5P_DEFAULT, H5P_DEFAULT);
    std::vector<int> values(count);
    H5Aread(attribute, H5T_NATIVE_INT, values.data());
    H5Aclose(attribute);
    return values;
  }
  haddr_t address(const char* path) const {
    H5O_info_t info;
    H5Oget_info_by_name(id, path, &info, H5P_DEFAULT);
    return info.addr;
  }
};

}  // namespace

TEST_CASE("A state file says that it is H5MD 1.1 by scree", "[bodies_writer]") {
  const File file(sample_state());
  CHECK(file.integers("h5md", "version", 2) == std::vector{1, 1});
  CHECK(file.attribute("h5md/creator", "name", 5) == "scree");
  CHECK(file.attribute("h5md/creator", "version", std::string(SCREE_TEST_VERSION).size()) ==
        SCREE_TEST_VERSION);
  CHECK_FALSE(file.attribute("h5md/author", "name", 10).empty());
  CHECK(file.integers("h5md/modules/units", "version", 2) == std::vector{1, 0});
  CHECK(file.attribute("h5md/modules/units", "system", 2) == "SI");
}

TEST_CASE("Bodies are elements of H5MD, with one time for all that changes", "[bodies_writer]") {
  const File file(sample_state());
  CHECK(file.values<double>("particles/bodies/position/value", H5T_NATIVE_DOUBLE, {1, 3, 3}) ==
        std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 0});
  CHECK(file.values<int>("particles/bodies/image/value", H5T_NATIVE_INT, {1, 3, 3})[3] == -1);
  CHECK(file.values<std::int64_t>("particles/bodies/id", H5T_NATIVE_INT64, {3})[2] == 1'000'000'000'000'000);
  CHECK(file.values<int>("particles/bodies/species", H5T_NATIVE_INT, {3}) == std::vector{0, 1, 0});
  CHECK(file.values<double>("particles/bodies/mass", H5T_NATIVE_DOUBLE, {3})[1] == 2e-3);
  CHECK(file.values<double>("particles/bodies/velocity/time", H5T_NATIVE_DOUBLE, {1})[0] == 0.1);
  CHECK(file.values<std::uint64_t>("particles/bodies/velocity/step", H5T_NATIVE_UINT64, {1})[0] == ~0ull);
  for (const char* element : {"velocity", "image", "box/edges"})
    for (const char* axis : {"/step", "/time"})
      CHECK(file.address(("particles/bodies/" + std::string(element) + axis).c_str()) ==
            file.address(("particles/bodies/position" + std::string(axis)).c_str()));
  CHECK(file.attribute("particles/bodies/velocity/value", "unit", 5) == "m s-1");
  CHECK(file.attribute("particles/bodies/position/time", "unit", 1) == "s");
  CHECK(file.attribute("particles/bodies/position/step", "unit", 1) == "1");
  CHECK(file.attribute("particles/bodies/species", "unit", 1) == "1");
}

TEST_CASE("An array without one row for each body is no element of H5MD", "[bodies_writer]") {
  const File file(odd_state());
  CHECK(file.has("scree/bodies/total"));
  CHECK_FALSE(file.has("particles/bodies/total"));
}

TEST_CASE("The box of H5MD has the periods of the scene", "[bodies_writer]") {
  const File file(sample_state());
  CHECK(file.integers("particles/bodies/box", "dimension", 1)[0] == 3);
  CHECK(file.attribute("particles/bodies/box", "boundary", 8) ==
        std::string("periodicnone\0\0\0\0none\0\0\0\0", 24));
  CHECK(file.values<double>("particles/bodies/box/edges/value", H5T_NATIVE_DOUBLE, {1, 3, 3}) ==
        std::vector<double>{10, 0, 0, 0, 0, 0, 0, 0, 0});
}

TEST_CASE("A scene without periods has a box without edges, and one without positions no bodies",
          "[bodies_writer]") {
  State state = sample_state();
  state.put("walls/domain_upper", state.at("walls/domain_lower"));
  const File walled(state);
  CHECK(walled.attribute("particles/bodies/box", "boundary", 4) == "nonenonenone");
  CHECK_FALSE(walled.has("particles/bodies/box/edges"));
  State clock;
  clock.put("clock/time", {std::vector<double>{1}, {}, "s"});
  CHECK_FALSE(File(clock).has("particles"));
}
