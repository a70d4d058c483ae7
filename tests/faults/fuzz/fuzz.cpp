// libFuzzer's entry: the reader is the one that the macro CAROM_READER names.
#include <cstddef>
#include <cstdint>

#include "readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const carom::test::FuzzedReader* const reader = carom::test::find_reader(CAROM_READER);
  reader->read({reinterpret_cast<const char*>(bytes), size});
  return 0;
}
