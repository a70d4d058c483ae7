#include "readers.hpp"

#include "carom/base/error.hpp"
#include "carom/io/checkpoint.hpp"
#include "carom/io/collide_batch.hpp"
#include "carom/io/scene_file.hpp"
#include "carom/state/scene.hpp"
#include "io/checkpoint_schema.hpp"
#include "io/h5md.hpp"

namespace carom::test {
namespace {

/// More disks take longer to place and to check, and tell nothing new.
constexpr std::size_t kMostDisks = 50;

/// What begins as an HDF5 file or a checkpoint goes to the readers of these, which have targets of their own.
void read_scene_called(std::string_view bytes, const char* name) {
  if (bytes.starts_with("\x89HDF") || is_checkpoint(bytes)) return;
  try {
    const SceneFile file = parse_scene(bytes, name);
    std::size_t disks = file.scene.disks.size();
    for (const GasSpec& gas : file.scene.gas) disks += gas.count.value_or(kMostDisks + 1);
    if (disks <= kMostDisks) static_cast<void>(problems_of(file.scene));
    static_cast<void>(to_toml(file));
  } catch (const Error&) {
  }
}

void read_frames(std::string_view bytes) {
  try {
    const auto reader = io::open_h5md_image(bytes, "fuzz.h5md");
    constexpr int kMostFrames = 10;
    for (int k = 0; k < kMostFrames && reader->next(); ++k) {
    }
    while (reader->skip()) {
    }
  } catch (const Error&) {
  }
}

void read_batch(std::string_view bytes) {
  try {
    static_cast<void>(collide_batch(bytes, "fuzz.csv", 1));
  } catch (const Error&) {
  }
}

void read_whole_checkpoint(std::string_view bytes) {
  try {
    static_cast<void>(parse_checkpoint(bytes, "fuzz.h5"));
  } catch (const Error&) {
  }
}

void read_content(std::string_view bytes) {
  try {
    Checkpoint checkpoint = io::read_checkpoint_image(bytes, "fuzz.h5");
    static_cast<void>(Simulation(std::move(checkpoint.snapshot)));
  } catch (const Error&) {
  }
}

}  // namespace

const std::vector<FuzzedReader>& fuzzed_readers() {
  static const std::vector<FuzzedReader> readers{
      {"toml", [](std::string_view bytes) { read_scene_called(bytes, "fuzz.toml"); }},
      {"algs4", [](std::string_view bytes) { read_scene_called(bytes, "fuzz.txt"); }},
      {"xyz", [](std::string_view bytes) { read_scene_called(bytes, "fuzz.xyz"); }},
      {"csv", read_batch},
      {"checkpoint", read_whole_checkpoint},
      {"checkpoint_content", read_content, true},
      {"h5md", read_frames, true}};
  return readers;
}

const FuzzedReader* find_reader(std::string_view name) {
  for (const FuzzedReader& reader : fuzzed_readers()) {
    if (reader.name == name) return &reader;
  }
  return nullptr;
}

}  // namespace carom::test
