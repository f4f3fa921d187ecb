#include "resealed.hpp"
#include "sample_state.hpp"
#include "seal.hpp"
#include "temporary_folder.hpp"

#include <algorithm>
#include <fcntl.h>
#include <functional>
#include <hdf5.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <scree/error.hpp>
#include <scree/state_file/state_file.hpp>

// Files with a right checksum that another program has changed.

using namespace scree;
using namespace scree::test;
using Catch::Matchers::Contains;

namespace {

void seal(const std::filesystem::path& file) {
  const int descriptor = open(file.c_str(), O_RDWR);
  state_file::write_seal(descriptor, file);
  close(descriptor);
}

// What read_state says of the sample after a change by the functions of HDF5; empty if it reads it.
std::string refusal_after(const std::function<void(hid_t)>& change) {
  const TemporaryFolder folder;
  const auto path = folder / "a.h5";
  state_file::write_state(path, sample_state());
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  change(file);
  H5Fclose(file);
  seal(path);
  try {
    return state_file::read_state(path) == sample_state() ? "" : "another state";
  } catch (const Error& error) {
    const std::string line = error.what();
    CHECK(error.status() == ExitStatus::bad_input);
    CHECK(line.starts_with(path.string() + ": "));
    CHECK(line.ends_with("; write it anew with this version of scree"));
    return line.substr(path.string().size() + 2);
  }
}

// As a file of format 1 has it.
void add_unit(hid_t dataset, const std::string& text = "m") {
  const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
  H5Tset_size(type, text.size());
  const hid_t unit = H5Acreate2(dataset, "units", type, space, H5P_DEFAULT, H5P_DEFAULT);
  H5Awrite(unit, type, text.c_str());
  H5Aclose(unit), H5Sclose(space), H5Tclose(type);
}

// Adds a dataset without values.
void add(hid_t file, const char* name, hid_t type, std::vector<hsize_t> shape,
         hid_t properties = H5P_DEFAULT) {
  const hid_t space = H5Screate_simple(int(shape.size()), shape.data(), nullptr);
  const hid_t dataset = H5Dcreate2(file, name, type, space, H5P_DEFAULT, properties, H5P_DEFAULT);
  REQUIRE(dataset >= 0);
  add_unit(dataset);
  H5Dclose(dataset), H5Sclose(space);
}

hid_t chunked() {
  const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
  const hsize_t chunk = 1000;
  H5Pset_chunk(properties, 1, &chunk);
  H5Pset_deflate(properties, 9);
  return properties;
}

}  // namespace

TEST_CASE("A dataset that claims a million bodies in a small file takes no memory", "[file_reader]") {
  CHECK_THAT(refusal_after([](hid_t file) { add(file, "scree/many", H5T_IEEE_F64LE, {1'000'000}); }),
             Contains("/scree/many claims more values than it has"));
  CHECK_THAT(refusal_after([](hid_t file) {
               add(file, "scree/many", H5T_IEEE_F64LE, {1ull << 40, 1ull << 40});
             }),
             Contains("/scree/many claims more values than it has"));
  CHECK_THAT(
      refusal_after([](hid_t file) { add(file, "scree/many", H5T_IEEE_F64LE, {1'000'000}, chunked()); }),
      Contains("/scree/many does not lie in the file in one piece"));
}

TEST_CASE("Datasets that share their bytes do not count as more than the file has", "[file_reader]") {
  const std::string line = refusal_after([](hid_t file) {
    add(file, "scree/large", H5T_IEEE_F64LE, {1000});
    const hid_t dataset = H5Dopen2(file, "scree/large", H5P_DEFAULT);
    const std::vector<double> values(1000);
    H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Dclose(dataset);
    for (const char* name : {"scree/b", "scree/c", "scree/d", "scree/e"})
      H5Lcreate_hard(file, "scree/large", file, name, H5P_DEFAULT, H5P_DEFAULT);
  });
  CHECK_THAT(line, Contains("claims more bytes than are in the file"));
}

TEST_CASE("Datasets that no state has are named", "[file_reader]") {
  const auto of_type = [](hid_t type) {
    return refusal_after([type](hid_t file) { add(file, "scree/odd", type, {0}); });
  };
  for (const hid_t type : {H5T_STD_I16LE, H5T_IEEE_F64BE, H5T_STD_I64BE, H5T_STD_REF_OBJ, H5T_STD_B8LE})
    CHECK_THAT(of_type(type), Contains("/scree/odd has a type that no state has"));
  const hid_t variable = H5Tcopy(H5T_C_S1);
  H5Tset_size(variable, H5T_VARIABLE);
  H5Tset_strpad(variable, H5T_STR_NULLPAD);
  CHECK_THAT(of_type(variable), Contains("/scree/odd has a type that no state has"));
  CHECK_THAT(refusal_after([](hid_t file) { add(file, "scree/Odd", H5T_IEEE_F64LE, {0}); }),
             Contains("/scree/Odd is not the name of an array of a state"));
  CHECK_THAT(
      refusal_after([](hid_t file) {
        const hid_t space = H5Screate(H5S_NULL);
        H5Dclose(H5Dcreate2(file, "scree/a", H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
      }),
      Contains("/scree/a has no shape"));
  CHECK_THAT(
      refusal_after([](hid_t file) { H5Adelete_by_name(file, "scree/clock/time", "unit", H5P_DEFAULT); }),
      Contains("/scree/clock/time has no unit"));
  CHECK_THAT(refusal_after([](hid_t file) {
               H5Ldelete(file, "particles/bodies/velocity/value", H5P_DEFAULT);
               add(file, "particles/bodies/velocity/value", H5T_IEEE_F64LE, {0, 3, 3});
             }),
             Contains("/particles/bodies/velocity/value is not the state at one time"));
}

TEST_CASE("Links out of their place are not followed", "[file_reader]") {
  CHECK_THAT(refusal_after([](hid_t file) {
               H5Lcreate_external("/etc/passwd", "/", file, "scree/other", H5P_DEFAULT, H5P_DEFAULT);
             }),
             Contains("/scree/other is a link out of its place"));
  CHECK_THAT(refusal_after([](hid_t file) {
               H5Lcreate_soft("/scree/clock/time", file, "scree/other", H5P_DEFAULT, H5P_DEFAULT);
             }),
             Contains("/scree/other is a link out of its place"));
  CHECK_THAT(refusal_after([](hid_t file) {
               const hid_t properties = H5Pcreate(H5P_DATASET_CREATE);
               H5Pset_external(properties, "/etc/passwd", 0, 8);
               add(file, "scree/other", H5T_STD_U8LE, {8}, properties);
             }),
             Contains("/scree/other does not lie in the file in one piece"));
}

TEST_CASE("Groups that hold themselves are read once, and what other programs add elsewhere is left out",
          "[file_reader]") {
  CHECK(refusal_after([](hid_t file) {
          H5Lcreate_hard(file, "scree", file, "observables", H5P_DEFAULT, H5P_DEFAULT);
          H5Ldelete(file, "observables", H5P_DEFAULT);
          add(file, "observables", H5T_IEEE_F64BE, {1'000'000});
          add(file, "particles/bodies/charge", H5T_IEEE_F64LE, {0});
        }) == "");
  CHECK(refusal_after([](hid_t file) {
          H5Lcreate_hard(file, "/", file, "h5md/root", H5P_DEFAULT, H5P_DEFAULT);
        }) == "");
}

TEST_CASE("Groups in many others are refused, and so are second names of groups", "[file_reader]") {
  const auto nested = [](int depth) {
    return refusal_after([depth](hid_t file) {
      std::string name = "scree";
      for (int k = 0; k < depth; ++k) {
        name += "/g";
        H5Gclose(H5Gcreate2(file, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
      }
    });
  };
  CHECK(nested(9) == "");
  CHECK_THAT(nested(10), Contains("/scree/g/g/g/g/g/g/g/g/g/g lies in too many groups"));
  CHECK_THAT(nested(2000), Contains("lies in too many groups"));
  CHECK_THAT(refusal_after([](hid_t file) {
               H5Lcreate_hard(file, "scree", file, "scree/again", H5P_DEFAULT, H5P_DEFAULT);
             }),
             Contains("/scree/again is a second name of a group"));
}

TEST_CASE("A file with any byte changed and sealed again is read or refused in one line", "[file_reader]") {
  const TemporaryFolder folder;
  state_file::write_state(folder / "a.h5", sample_state());
  const std::string sound = text_of(folder / "a.h5");
  std::size_t refused = 0, read = 0;
  for (std::size_t at = 512; at < sound.size(); at += 11) {
    std::string changed = sound;
    changed[at] = char(changed[at] ^ (at % 2 ? 0xFF : 1 << (at / 11 % 8)));
    const auto file = folder.write("b.h5", resealed(changed));
    try {
      state_file::read_state(file);
      ++read;
    } catch (const Error& error) {
      const std::string line = error.what();
      CHECK((line.starts_with(file.string() + ": ") && line.find('\n') == line.npos));
      CHECK(line.ends_with("; write it anew with this version of scree"));
      ++refused;
    }
  }
  CHECK(refused > 0);
  CHECK(read > 0);
}

TEST_CASE("A file of the format before is read", "[file_reader]") {
  const TemporaryFolder folder;
  const auto path = folder / "a.h5";
  state_file::write_state(path, sample_state());
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  const std::pair<const char*, const char*> units[] = {{"particles/bodies/velocity/value", "m/s"},
                                                       {"particles/bodies/position/value", "m"}};
  for (const auto& [name, unit] : units) {
    const hid_t dataset = H5Dopen2(file, name, H5P_DEFAULT);
    H5Adelete(dataset, "unit");
    add_unit(dataset, unit);
    H5Dclose(dataset);
  }
  H5Fclose(file);
  const std::string bytes = text_of(path);
  CHECK(state_file::read_state(folder.write(
            "b.h5", resealed(bytes, {.format = 1, .program_version = "0.1.0"}))) == sample_state());
}

TEST_CASE("A sealed file that is not HDF5 is refused", "[file_reader]") {
  const TemporaryFolder folder;
  const auto file = folder.write("a.h5", std::string(4096, 'x'));
  seal(file);
  CHECK_THROWS_WITH(state_file::read_state(file),
                    Contains("a.h5: is not an HDF5 file") && Contains("; write it anew"));
}
