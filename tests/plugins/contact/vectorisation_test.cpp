#include <array>
#include <cstdio>
#include <map>
#include <memory>
#include <string>

#include <catch2/catch.hpp>

// The batch loop of every contact law must use full vector registers; checked in the machine code.

namespace {

// Multiplications on registers of full width of each evaluate_batch instance in a library, by symbol.
std::map<std::string, int> disassemble(const std::string& library, const std::string& vector_register) {
  const std::string command = "objdump -d --no-show-raw-insn '" + library + "'";
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
  REQUIRE(pipe);
  std::map<std::string, int> all;
  std::string symbol;
  for (std::array<char, 4096> buffer; std::fgets(buffer.data(), buffer.size(), pipe.get());) {
    const std::string line = buffer.data();
    // A function begins with "<address> <symbol>:" in the first column.
    if (!line.empty() && line[0] != ' ')
      symbol = line.find("evaluate_batch") != std::string::npos ? line : "";
    if (symbol.empty() || line.find(vector_register) == std::string::npos) continue;
    const auto holds = [&](const char* instruction) { return line.find(instruction) != std::string::npos; };
    if (holds("mulpd")) ++all[symbol];
  }
  return all;
}

}  // namespace

// Not the baseline of x86-64: without the instruction a fused multiply-add is a function call.
TEST_CASE("every batch loop of every contact law is vectorised at every level", "[vectorisation]") {
  const std::string folder = SCREE_TEST_PLUGINS "/contact/";
  // Kernels × dimensions × with and without audit. A kernel that follows steps backwards in time is compiled
  // twice, and once more if it follows onsets; all these twice if it follows surfaces.
  for (const auto& [law, loops] :
       {std::pair<std::string, std::size_t>{"linear_spring_dashpot", (24 + 16 + 4) * 2 * 2},
        {"hertz_mindlin", (8 + 6) * 2 * 2},
        {"disc_cundall_strack", 4 * 2},
        {"disc_corrected", 4 * 2},
        {"disc_angular", 4 * 2},
        {"sphere_path_independent", (3 + 2 * (5 + 5 + 2)) * 2}})
    for (const auto& [level, vector_register] :
         {std::pair<std::string, std::string>{"x86-64-v3/", "%ymm"}, {"x86-64-v4/", "%zmm"}}) {
      const auto functions = disassemble(folder + level + law + ".so", vector_register);
      INFO(law << " at " << level << ": " << functions.size() << " functions");
      CHECK(functions.size() == loops);
      for (const auto& [symbol, packed] : functions) {
        INFO(symbol);
        CHECK(packed >= 5);
      }
    }
}
