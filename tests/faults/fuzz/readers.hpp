// Every reader of files, given bytes that nobody has written on purpose. Errors are what is expected; anything else
// (a crash, a hang, memory without end) is found by whoever calls.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace carom::test {

struct FuzzedReader {
  const char* name;  ///< of the reader and of its folder of seeds
  void (*read)(std::string_view bytes);
  bool needs_helper = false;  ///< hands most inputs to HDF5
};

/// toml, algs4, xyz, csv, checkpoint (the whole file), checkpoint_content (behind its checksum) and h5md.
const std::vector<FuzzedReader>& fuzzed_readers();

/// The reader of that name, or null.
const FuzzedReader* find_reader(std::string_view name);

}  // namespace carom::test
