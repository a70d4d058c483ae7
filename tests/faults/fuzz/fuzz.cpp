// libFuzzer's entry: the reader is the one that the macro CAROM_READER names.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "helper.hpp"
#include "readers.hpp"

namespace {

/// libFuzzer limits the time by the clock, in which other programs take part.
void require_soon(std::clock_t start) {
  if (std::clock() - start <= CLOCKS_PER_SEC) return;
  std::fprintf(stderr, "ERROR: more than a second of processor time\n");
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const carom::test::FuzzedReader* const reader = carom::test::find_reader(CAROM_READER);
  const std::string_view input(reinterpret_cast<const char*>(bytes), size);
  const std::clock_t start = std::clock();
  if (reader->needs_helper) {
    carom::test::read_in_helper(*reader, input);
  } else {
    reader->read(input);
  }
  require_soon(start);
  return 0;
}
