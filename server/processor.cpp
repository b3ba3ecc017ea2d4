// The processor check. A build for x86-64-v2, -v3 or -v4 stops here, with a message, on a
// processor that lacks the instructions: before any constructor of ours or of a library runs.
// Compiled for baseline x86-64 (CMakeLists.txt), so it uses no inline function from a header
// that other files share: the linker might keep their copy of it.
#if TIA_ARCH_LEVEL + 0 >= 2

#include <cpuid.h>
#include <unistd.h>

namespace {

/// One line of the x86-64 psABI's table of microarchitecture levels.
struct Feature {
  int level;
  unsigned leaf;
  char reg;  ///< which of cpuid's answers: 'b', 'c' or 'd'
  int bit;
  const char* name;
};

/// Source: System V ABI, AMD64 supplement 1.0, table 3.1.
constexpr Feature features[] = {
    {2, 1, 'c', 0, "sse3"},           {2, 1, 'c', 9, "ssse3"},     {2, 1, 'c', 13, "cmpxchg16b"},
    {2, 1, 'c', 19, "sse4.1"},        {2, 1, 'c', 20, "sse4.2"},   {2, 1, 'c', 23, "popcnt"},
    {2, 0x80000001, 'c', 0, "lahf"},  {3, 1, 'c', 12, "fma"},      {3, 1, 'c', 22, "movbe"},
    {3, 1, 'c', 27, "osxsave"},       {3, 1, 'c', 28, "avx"},      {3, 1, 'c', 29, "f16c"},
    {3, 7, 'b', 3, "bmi1"},           {3, 7, 'b', 5, "avx2"},      {3, 7, 'b', 8, "bmi2"},
    {3, 0x80000001, 'c', 5, "lzcnt"}, {4, 7, 'b', 16, "avx512f"},  {4, 7, 'b', 17, "avx512dq"},
    {4, 7, 'b', 28, "avx512cd"},      {4, 7, 'b', 30, "avx512bw"}, {4, 7, 'b', 31, "avx512vl"},
};

bool present(const Feature& feature) {
  unsigned a = 0, b = 0, c = 0, d = 0;
  if (__get_cpuid_count(feature.leaf, 0, &a, &b, &c, &d) == 0) return false;
  const unsigned word = feature.reg == 'b' ? b : feature.reg == 'c' ? c : d;
  return (word >> feature.bit & 1) != 0;
}

/// Whether the operating system saves the wide registers: the processor may have them, and a
/// kernel or a virtual machine still keep them off. Only valid where osxsave is present.
bool registers_enabled() {
  constexpr unsigned needed = TIA_ARCH_LEVEL >= 4 ? 0xe6 : 0x06;  // xmm ymm; opmask zmm
  unsigned low = 0, high = 0;
  asm volatile("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return (low & needed) == needed;
}

void say(const char* text) {
  unsigned long length = 0;
  while (text[length] != '\0') ++length;
  if (write(STDERR_FILENO, text, length) < 0) _exit(2);
}

void check_processor() {
  constexpr char level[] = {'0' + TIA_ARCH_LEVEL, '\0'};
  bool complete = true;
  const auto missing = [&](const char* name) {
    if (complete) {
      say("tia: this build needs an x86-64-v");
      say(level);
      say(" processor; this one lacks:");
    }
    complete = false;
    say(" ");
    say(name);
  };
  for (const Feature& feature : features) {
    if (feature.level <= TIA_ARCH_LEVEL && !present(feature)) missing(feature.name);
  }
  if (complete && TIA_ARCH_LEVEL >= 3 && !registers_enabled()) {
    missing("wide registers (switched off by the operating system)");
  }
  if (complete) return;
  say("\ntia: to build for any x86-64 processor:"
      " cmake --preset release -DTIA_ARCH=x86-64 && cmake --build --preset release"
      "\ntia: as a container: --build-arg TIA_ARCH=x86-64\n");
  _exit(2);
}

/// .preinit_array runs before the constructors of the shared libraries, which may already call
/// into our copies of templates that they share with us.
[[gnu::used, gnu::section(".preinit_array")]] void (*const check)() = check_processor;

}  // namespace

#endif
