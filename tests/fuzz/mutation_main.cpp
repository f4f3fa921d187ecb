#include "support.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

// Runs a fuzz target without libFuzzer, for any compiler: mutates seeds at random, always the same way, for a
// number of seconds. Usage: <target> FINDING SECONDS FOLDER-OR-SEED... Prints the number of inputs. The input
// that ends the program is in the file FINDING.

namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

Bytes input;
const char* finding;

std::uint64_t random_number() {
  static std::uint64_t state = 0x9e3779b97f4a7c15u;
  state ^= state << 13;
  state ^= state >> 7;
  return state ^= state << 17;
}
std::size_t random_below(std::size_t bound) { return bound == 0 ? 0 : random_number() % bound; }

void keep_input(int signal) {
  std::ofstream(finding, std::ios::binary)
      .write(reinterpret_cast<const char*>(input.data()), std::streamsize(input.size()));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void insert(const char* text) {
  const std::size_t at = random_below(input.size() + 1);
  input.insert(input.begin() + std::ptrdiff_t(at), text, text + std::strlen(text));
}

// One change: a byte, a part left out, doubled or taken from another seed, or a piece that often causes
// trouble.
void mutate(const std::vector<Bytes>& seeds) {
  static constexpr const char* pieces[] = {
      "0",  "-1", "1e308", "1e-320", "nan", "inf",  "99999999999999999999",
      "\"", "'",  "[",     "]",      "{",   "}",    "=",
      ",",  ".",  "\n",    "\r",     "#",   "\x80", "\x1b[2J"};
  const std::size_t at = random_below(input.size()),
                    length = random_below(std::min<std::size_t>(input.size() - at, 64));
  const auto begin = input.begin() + std::ptrdiff_t(at), end = begin + std::ptrdiff_t(length);
  switch (random_below(6)) {
    case 0:
      if (!input.empty()) *begin = std::uint8_t(random_number());
      break;
    case 1:
      if (!input.empty()) *begin ^= std::uint8_t(1u << random_below(8));
      break;
    case 2:
      input.erase(begin, end);
      break;
    case 3: {
      const Bytes part(begin, end);
      const auto to = input.begin() + std::ptrdiff_t(random_below(input.size() + 1));
      input.insert(to, part.begin(), part.end());
      break;
    }
    case 4: {
      const Bytes& other = seeds[random_below(seeds.size())];
      const std::size_t from = random_below(other.size());
      input.insert(begin, other.begin() + std::ptrdiff_t(from),
                   other.begin() + std::ptrdiff_t(std::min(other.size(), from + 64)));
      break;
    }
    default:
      insert(pieces[random_below(std::size(pieces))]);
  }
}

void add_seed(const fs::path& file, std::vector<Bytes>& seeds) {
  std::ifstream stream(file, std::ios::binary);
  seeds.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  constexpr std::size_t longest = 16384;
  if (seeds.back().size() > longest) seeds.pop_back();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return std::fprintf(stderr, "usage: %s FINDING SECONDS SEED...\n", argv[0]), 2;
  finding = argv[1];
  std::vector<Bytes> seeds;
  for (int k = 3; k < argc; ++k) add_seed(argv[k], seeds);
  if (seeds.empty()) return std::fprintf(stderr, "no seeds\n"), 2;
  for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL}) std::signal(signal, keep_input);

  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(std::atof(argv[2]));
  std::size_t count = 0;
  for (; std::chrono::steady_clock::now() < end; ++count) {
    input = seeds[count % seeds.size()];
    if (count >= seeds.size())
      for (std::size_t k = 1 + random_below(8); k > 0; --k) mutate(seeds);
    LLVMFuzzerTestOneInput(input.data(), input.size());
  }
  std::printf("%zu inputs\n", count);
  return 0;
}
