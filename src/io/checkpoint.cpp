// The envelope of a checkpoint: its first 512 bytes tell whether the rest is what was written.
#include "carom/io/checkpoint.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>

#include "carom/base/digest.hpp"
#include "carom/base/error.hpp"
#include "carom/io/file.hpp"
#include "checkpoint_schema.hpp"
#include "hdf5/trial.hpp"
#include "numbers.hpp"
#include "words.hpp"

namespace carom {
namespace {

constexpr std::string_view kCheckpointMark = "carom checkpoint\n";
constexpr std::uint64_t kVersion = 1;
/// Bytes before the HDF5 file proper: what HDF5 calls a user block, which its readers skip.
constexpr std::size_t kHead = 512;

/// What the envelope says of the bytes after it.
struct Envelope {
  std::uint64_t version = 0;
  std::uint64_t bytes = 0;
  std::string digest;
};

std::string text_of(const Envelope& envelope) {
  return fmt::format("{}version {}\nbytes {}\nxxh3 {}\n", kCheckpointMark, envelope.version, envelope.bytes,
                     envelope.digest);
}

/// The word after `key` at the start of the next line.
std::optional<std::string_view> value_of(std::string_view key, std::string_view& text) {
  const std::string_view line = io::take_line(text);
  if (!line.starts_with(key) || line.size() <= key.size() || line[key.size()] != ' ') return std::nullopt;
  return line.substr(key.size() + 1);
}

Envelope read_envelope(std::string_view bytes, const std::string& name) {
  if (!is_checkpoint(bytes)) throw Error("this is not a checkpoint", {name});
  std::string_view text = bytes.substr(kCheckpointMark.size(), kHead);
  const auto version = io::parse_count(value_of("version", text).value_or(""));
  if (version && *version > kVersion) {
    throw Error(fmt::format("this checkpoint has format {}, this carom reads formats up to {}: use a newer one",
                            *version, kVersion),
                {name});
  }
  const auto length = io::parse_count(value_of("bytes", text).value_or(""));
  const auto digest = value_of("xxh3", text);
  if (!version || *version == 0 || !length || !digest) throw Error("the checkpoint is damaged: its head", {name});
  return {*version, *length, std::string(*digest)};
}

/// The bytes of a file, or nothing if it is not there.
std::optional<std::string> bytes_of(const std::string& path) {
  std::error_code error;
  const bool there = std::filesystem::exists(path, error);
  if (error) throw Error("cannot be read: " + error.message(), {path});
  return there ? std::optional(read_file(path)) : std::nullopt;
}

}  // namespace

bool is_checkpoint(std::string_view bytes) noexcept { return bytes.starts_with(kCheckpointMark); }

bool is_checkpoint_file(const std::string& path) {
  std::error_code unknown;
  if (path == "-" || !std::filesystem::is_regular_file(path, unknown)) return false;
  std::ifstream file(path, std::ios::binary);
  std::string head(kCheckpointMark.size(), '\0');
  return file.read(head.data(), static_cast<std::streamsize>(head.size())) && is_checkpoint(head);
}

std::string checkpoint_bytes(const Checkpoint& checkpoint) {
  const std::string content = io::checkpoint_image(checkpoint);
  std::string bytes = text_of({kVersion, content.size(), digest_of_bytes(content)});
  bytes.resize(kHead);
  return bytes + content;
}

void write_checkpoint(const std::string& path, const std::string& previous, const Checkpoint& checkpoint) {
  write_file(path, checkpoint_bytes(checkpoint), previous);
}

Checkpoint parse_checkpoint(std::string_view bytes, const std::string& name) {
  const Envelope envelope = read_envelope(bytes, name);
  const std::string_view content = bytes.substr(std::min(kHead, bytes.size()));
  if (content.size() != envelope.bytes) {
    throw Error(fmt::format("the checkpoint is damaged: {} bytes where {} belong", content.size(), envelope.bytes),
                {name});
  }
  const std::string_view head = bytes.substr(0, kHead);
  const bool rest_is_empty = head.find_first_not_of('\0', text_of(envelope).size()) == std::string_view::npos;
  if (digest_of_bytes(content) != envelope.digest || !rest_is_empty) {
    throw Error("the checkpoint is damaged: its content has changed since it was written", {name});
  }
  return io::read_checkpoint_image(content, name);
}

Checkpoint read_checkpoint(const std::string& path) { return parse_checkpoint(read_file(path), display_name(path)); }

std::optional<NewestCheckpoint> read_newest_checkpoint(const std::vector<std::string>& paths) {
  std::vector<Problem> problems;
  for (const std::string& path : paths) {
    const std::optional<std::string> bytes = bytes_of(path);
    if (!bytes) continue;
    try {
      return NewestCheckpoint{parse_checkpoint(*bytes, path), path, problems};
    } catch (const io::NotTried&) {
      throw;
    } catch (const Error& failure) {
      problems.insert(problems.end(), failure.problems().begin(), failure.problems().end());
    }
  }
  if (!problems.empty()) throw Error(problems);
  return std::nullopt;
}

}  // namespace carom
