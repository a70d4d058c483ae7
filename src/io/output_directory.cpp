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

/// What a run left in the directory of its observables, and then that directory, so that it can be removed empty.
std::vector<fs::path> tables_of_a_run(const std::string& directory) {
  const fs::path observables = fs::path(directory) / "observables";
  std::error_code error;
  std::vector<fs::path> files;
  if (!fs::is_regular_file(observables / "index.json", error)) return files;
  bool others = false;
  for (fs::directory_iterator entry(observables, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const bool ours = entry->path().extension() == ".csv" || entry->path().filename() == "index.json";
    if (ours) files.push_back(entry->path());
    others = others || !ours;
  }
  if (error) throw Error("cannot be listed: " + error.message(), {observables.string()});
  if (!others) files.push_back(observables);
  return files;
}

std::vector<fs::path> files_of_a_run(const std::string& directory) {
  std::vector<fs::path> files;
  std::error_code error;
  fs::directory_iterator entry(directory, error);
  while (!error && entry != fs::directory_iterator()) {
    if (belongs_to_a_run(entry->path().filename().string())) files.push_back(entry->path());
    entry.increment(error);
  }
  const std::vector<fs::path> tables = tables_of_a_run(directory);
  files.insert(files.end(), tables.begin(), tables.end());
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
