#include "sample_state.hpp"
#include "seal.hpp"
#include "support.hpp"
#include "temporary_folder.hpp"

#include <fcntl.h>
#include <fstream>
#include <unistd.h>

#include <scree/state_file/state_file.hpp>

namespace {

using namespace scree;
namespace fs = std::filesystem;

void write(const fs::path& file, std::string_view bytes) { std::ofstream(file, std::ios::binary) << bytes; }

std::string sample_bytes(const fs::path& file) {
  state_file::write_state(file, test::sample_state());
  return test::text_of(file);
}

}  // namespace

// A state file: the input as it is, and a sound file of which the input changes bytes (two bytes for the
// place, one for the value), with a right seal, so that the change is left to the reader of HDF5.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const fs::path file =
      fs::temp_directory_path() / ("scree_fuzz_state_" + std::to_string(getpid()) + ".h5");
  static const std::string sample = sample_bytes(file);
  write(file, fuzz::text_of(data, size));
  fuzz::accept_or_refuse([] { state_file::read_state(file); });

  std::string changed = sample;
  for (std::size_t k = 0; k + 3 <= size && k < 30; k += 3) {
    const std::size_t place = data[k] * 256u + data[k + 1];
    changed[state_file::Seal::size + place % (changed.size() - state_file::Seal::size)] = char(data[k + 2]);
  }
  write(file, changed);
  const int descriptor = open(file.c_str(), O_RDWR);
  state_file::write_seal(descriptor, file);
  close(descriptor);
  return fuzz::accept_or_refuse([] { state_file::read_state(file); });
}
