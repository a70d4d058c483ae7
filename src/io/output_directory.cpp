#include "carom/io/output_directory.hpp"

#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "carom/base/error.hpp"
#include "carom/io/file.hpp"

namespace carom {
namespace {

namespace fs = std::filesystem;

bool belongs_to_a_run(const std::string& name) {
  for (const char* const known : {"report.json", "scene.toml", "final.xyz", "collisions.csv", "checkpoint.h5"}) {
    if (name == known) return true;
  }
  return name.starts_with("trajectory.");
}

std::vector<fs::path> files_of_a_run(const std::string& directory) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::directory_iterator entry(directory, error);
  while (!error && entry != fs::directory_iterator()) {
    if (belongs_to_a_run(entry->path().filename().string())) files.push_back(entry->path());
    entry.increment(error);
  }
  if (error) throw Error("cannot be listed: " + error.message(), {directory});
  return files;
}

void create(const std::string& directory) {
  std::error_code error;
  if (fs::exists(directory, error) && !fs::is_directory(directory, error)) {
    throw Error("is not a directory: the output needs one", {directory});
  }
  fs::create_directories(directory, error);
  if (error) throw Error("cannot be created: " + error.message(), {directory});
}

/// Finds out by doing it: permissions do not tell of read-only and full file systems.
void prove_writable(const std::string& directory, const std::string& trial) {
  try {
    write_file(trial, "carom writes here\n");
  } catch (const Error& error) {
    const std::string& message = error.problems().front().message;
    throw Error("no file can be written here (" + message + ')', {directory});
  }
  std::error_code ignored;
  fs::remove(trial, ignored);
}

}  // namespace

OutputDirectory::OutputDirectory(std::string path, bool overwrite) : path_(std::move(path)) {
  create(path_);
  const std::vector<fs::path> old = files_of_a_run(path_);
  if (!old.empty() && !overwrite) {
    throw Error("holds a run already (" + old.front().filename().string() + "): choose another or overwrite it",
                {path_});
  }
  prove_writable(path_, in(".carom-trial"));
  for (const fs::path& file : old) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw Error("cannot be removed: " + error.message(), {file.string()});
  }
}

std::string OutputDirectory::in(std::string_view name) const { return (fs::path(path_) / name).string(); }

}  // namespace carom
