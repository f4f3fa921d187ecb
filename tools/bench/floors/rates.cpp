// Rates of one core: the least time of an instruction of each class, of a cache line from the second-level
// cache and from memory, and of a reading of the clock. Prints a table "name,ns", which
// tools/bench/floors/table combines with counts of instructions. For x86-64 with AVX2.

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

#if !defined(__x86_64__)
int main() {
  std::fputs("rates: this processor has other instructions; only x86-64 is measured\n", stderr);
  return 2;
}
#else

namespace {

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Least time of a call (s), of 40 samples of about 2 ms: other load and lower frequencies only add to it.
template <class Run>
double least_seconds(const Run& run) {
  std::size_t calls = 1;
  double best = std::numeric_limits<double>::infinity();
  for (int sample = 0; sample < 40; ++sample) {
    const double start = seconds();
    for (std::size_t k = 0; k < calls; ++k) run();
    const double each = (seconds() - start) / double(calls);
    best = std::min(best, each);
    if (each * double(calls) < 1e-3) calls *= 4, --sample;
  }
  return best;
}

void print(const char* name, double s) { std::printf("%s,%.5f\n", name, 1e9 * s); }

constexpr std::size_t rounds = 4096, per_round = 12;

// Twelve instructions that do not depend on each other, again and again. They may read and write 768 bytes.
#define TWELVE(op) \
  op("0") op("1") op("2") op("3") op("4") op("5") op("6") op("7") op("8") op("9") op("10") op("11")
#define ROUNDS(twelve)                                                                                     \
  [](void* at) {                                                                                           \
    std::size_t left = rounds;                                                                             \
    asm volatile("vxorps %%xmm14, %%xmm14, %%xmm14\nvxorps %%xmm15, %%xmm15, %%xmm15\n1:\n" twelve         \
                 "dec %0\njnz 1b\nvzeroupper\n"                                                            \
                 : "+r"(left)                                                                              \
                 : "r"(at)                                                                                 \
                 : "cc", "memory", "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7", "xmm8", \
                   "xmm9", "xmm10", "xmm11", "xmm12", "xmm13", "xmm14", "xmm15");                          \
  }

// name, of registers of a width ("ymm", "zmm"), with two sources of their own.
#define OF_TWO(name, width, r) name " %%" width "14, %%" width "15, %%" width r "\n"
#define MULTIPLY_256(r) OF_TWO("vfmadd231pd", "ymm", r)
#define MULTIPLY_512(r) OF_TWO("vfmadd231pd", "zmm", r)
#define ADD_256(r) OF_TWO("vaddpd", "ymm", r)
#define ADD_512(r) OF_TWO("vaddpd", "zmm", r)
#define COMPARE_256(r) OF_TWO("vcmpltpd", "ymm", r)
#define COMPARE_512(r) "vcmpltpd %%zmm14, %%zmm15, %%k1\n"
#define LARGER_256(r) OF_TWO("vmaxpd", "ymm", r)
#define LARGER_512(r) OF_TWO("vmaxpd", "zmm", r)
#define SHIFT_256(r) "vpsrlq $1, %%ymm14, %%ymm" r "\n"
#define SHIFT_512(r) "vpsrlq $1, %%zmm14, %%zmm" r "\n"
#define BITS_256(r) OF_TWO("vpxor", "ymm", r)
#define BITS_512(r) OF_TWO("vpxorq", "zmm", r)
#define SHUFFLE_256(r) OF_TWO("vpunpcklqdq", "ymm", r)
#define SHUFFLE_512(r) OF_TWO("vpunpcklqdq", "zmm", r)
#define CROSS_256(r) OF_TWO("vperm2f128 $0x31,", "ymm", r)
#define CROSS_512(r) OF_TWO("vshuff64x2 $0x44,", "zmm", r)
#define LOAD_256(r) "vmovapd 64*" r "(%1), %%ymm" r "\n"
#define LOAD_512(r) "vmovapd 64*" r "(%1), %%zmm" r "\n"
#define STORE_256(r) "vmovapd %%ymm" r ", 64*" r "(%1)\n"
#define STORE_512(r) "vmovapd %%zmm" r ", 64*" r "(%1)\n"
#define NOTHING(r) "nop\n"
#define MIX(a, b, c, d) a("0") b("1") c("2") d("3") a("4") b("5") c("6") d("7") a("8") b("9") c("10") d("11")

template <class Run>
double least_of_one(const Run& run, void* block) {
  return least_seconds([&] { run(block); }) / double(rounds * per_round);
}

// The least time of several mixtures bounds those of others: comparisons may share units with
// multiplications, or not, and maxima and shifts with additions.
#define LEAST(one, other, block) \
  std::min(least_of_one(ROUNDS(TWELVE(one)), block), least_of_one(ROUNDS(MIX(one, other, one, other)), block))
#define PRINT_CLASSES(width, block)                                                 \
  const double shift = LEAST(ADD_##width, SHIFT_##width, block);                    \
  print("multiply_" #width, LEAST(MULTIPLY_##width, COMPARE_##width, block));       \
  print("add_" #width, std::min(shift, LEAST(ADD_##width, LARGER_##width, block))); \
  print("shuffle_" #width, least_of_one(ROUNDS(TWELVE(SHUFFLE_##width)), block));   \
  print("cross_" #width, least_of_one(ROUNDS(TWELVE(CROSS_##width)), block));       \
  print("load_" #width, least_of_one(ROUNDS(TWELVE(LOAD_##width)), block));         \
  print("store_" #width, least_of_one(ROUNDS(TWELVE(STORE_##width)), block));       \
  print("any_" #width,                                                              \
        std::min(LEAST(MULTIPLY_##width, ADD_##width, block), LEAST(BITS_##width, ADD_##width, block)))

constexpr std::size_t line = 64;

// Reads, or reads and writes, all cache lines of a block in order.
template <bool writes>
void pass_over(char* block, std::size_t bytes) {
  for (char *at = block, *end = block + bytes; at < end; at += 4 * line)
    if constexpr (writes)
      asm volatile(
          "vmovapd (%0), %%ymm0\nvmovapd 32(%0), %%ymm1\nvmovapd 64(%0), %%ymm2\nvmovapd 96(%0), %%ymm3\n"
          "vmovapd 128(%0), %%ymm4\nvmovapd 160(%0), %%ymm5\nvmovapd 192(%0), %%ymm6\nvmovapd 224(%0), %%ymm7\n"
          "vmovapd %%ymm0, (%0)\nvmovapd %%ymm1, 32(%0)\nvmovapd %%ymm2, 64(%0)\nvmovapd %%ymm3, 96(%0)\n"
          "vmovapd %%ymm4, 128(%0)\nvmovapd %%ymm5, 160(%0)\nvmovapd %%ymm6, 192(%0)\nvmovapd %%ymm7, 224(%0)\n"
          :
          : "r"(at)
          : "memory", "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7");
    else
      asm volatile(
          "vmovapd (%0), %%ymm0\nvmovapd 32(%0), %%ymm1\nvmovapd 64(%0), %%ymm2\nvmovapd 96(%0), %%ymm3\n"
          "vmovapd 128(%0), %%ymm4\nvmovapd 160(%0), %%ymm5\nvmovapd 192(%0), %%ymm6\nvmovapd 224(%0), %%ymm7\n"
          :
          : "r"(at)
          : "memory", "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7");
}

template <bool writes>
double least_of_line(char* block, std::size_t bytes) {
  return least_seconds([&] { pass_over<writes>(block, bytes); }) / double(bytes / line);
}

}  // namespace

int main() {
  if (!__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma")) {
    std::fputs("rates: this processor has no AVX2; its rates are not measured\n", stderr);
    return 2;
  }
  // A quarter of the smallest first level, half of the smallest second level, beyond any third.
  constexpr std::size_t large_page = std::size_t(1) << 21, second_level = std::size_t(1) << 18,
                        memory = std::size_t(1) << 29;
  char* const block = static_cast<char*>(::operator new(memory, std::align_val_t(large_page)));
#if defined(__linux__)
  ::madvise(block, memory, MADV_HUGEPAGE);
#endif
  std::fill(block, block + memory, char(0));
  std::puts("name,ns");
  { PRINT_CLASSES(256, block); }
  if (__builtin_cpu_supports("avx512f")) {
    PRINT_CLASSES(512, block);
  }
  print("issue", least_of_one(ROUNDS(TWELVE(NOTHING)), block));
  print("clock", least_seconds([] { return std::chrono::steady_clock::now(); }));
  print("second_level_read", least_of_line<false>(block, second_level));
  print("second_level_update", least_of_line<true>(block, second_level));
  print("memory_read", least_of_line<false>(block, memory));
  print("memory_update", least_of_line<true>(block, memory));
  ::operator delete(block, std::align_val_t(large_page));
}

#endif
