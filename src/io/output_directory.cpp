#include "carom/io/output_directory.hpp"

#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "carom/base/error.hpp"
#include "carom/io/directory_lock.hpp"
#include "carom/io/file.hpp"

namespace carom {
namespace {

namespace fs = std::filesystem;

constexpr const char* kTrial = ".carom-trial";

/// The name that a file is to get which is written under another first: that name, ".new-" and numbers.
std::string finished_name(const std::string& name) {
  const std::size_t mark = name.rfind(".new-");
  if (mark == std::string::npos) return name;
  const bool numbers = name.find_first_not_of("0123456789-", mark + std::string(".new-").size()) == std::string::npos;
  return numbers ? name.substr(0, mark) : name;
}

bool is_unfinished(const std::string& name) { return finished_name(name) != name; }

bool belongs_to_a_run(const std::string& name) {
  const std::string finished = finished_name(name);
  for (const char* const known : {"report.json", "scene.toml", "final.xyz", "collisions.csv", "checkpoint.h5",
                                  "checkpoint-1.h5", "trajectory.xyz", "trajectory.h5md", kTrial}) {
    if (finished == known) return true;
  }
  return false;
}

/// What a run left in the directory of its observables, and then that directory, so that it can be removed empty.
/// Without an index only what is half-written was surely a run's.
std::vector<fs::path> tables_of_a_run(const std::string& directory) {
  const fs::path observables = fs::path(directory) / "observables";
  std::error_code error;
  std::vector<fs::path> files;
  if (!fs::is_directory(observables, error)) return files;
  const bool complete = fs::is_regular_file(observables / "index.json", error);
  bool others = !complete;
  error.clear();
  for (fs::directory_iterator entry(observables, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    const fs::path finished = finished_name(name);
    const bool table = finished.extension() == ".csv" || finished == "index.json";
    const bool ours = table && (complete || is_unfinished(name));
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

void refuse_old_run(const std::string& directory) {
  std::vector<fs::path> old = files_of_a_run(directory);
  std::erase_if(old, [](const fs::path& file) { return file.filename() == kTrial || is_unfinished(file.filename()); });
  if (old.empty()) return;
  throw Error("holds a run already (" + old.front().filename().string() + "): choose another or overwrite it",
              {directory});
}

void remove_file(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) throw Error("cannot be removed: " + error.message(), {file.string()});
}

}  // namespace

OutputDirectory::OutputDirectory(std::string path, bool overwrite) : path_(std::move(path)) {
  create(path_);
  lock_ = std::make_shared<const DirectoryLock>(path_);
  if (!overwrite) refuse_old_run(path_);  // under the lock: another may have come and gone until then
  prove_writable(path_, in(kTrial));
}

OutputDirectory OutputDirectory::of_run(std::string path) {
  OutputDirectory directory;
  directory.path_ = std::move(path);
  directory.lock_ = std::make_shared<const DirectoryLock>(directory.path_);
  prove_writable(directory.path_, directory.in(kTrial));
  return directory;
}

void OutputDirectory::remove_old_run() const {
  for (const fs::path& file : files_of_a_run(path_)) remove_file(file);
}

void OutputDirectory::remove_unfinished_files() const {
  for (const fs::path& file : files_of_a_run(path_)) {
    if (is_unfinished(file.filename().string())) remove_file(file);
  }
}

void OutputDirectory::make_newest(const std::string& path) const {
  std::error_code none;
  if (fs::equivalent(path, checkpoint(), none)) return;
  write_file(checkpoint(), read_file(path));
  if (!fs::equivalent(path, previous_checkpoint(), none)) remove_file(previous_checkpoint());
}

void OutputDirectory::require_still_there() const {
  if (!lock_->is_at(path_)) throw Error("was deleted or replaced while the run was writing there", {path_});
}

std::string OutputDirectory::in(std::string_view name) const { return (fs::path(path_) / name).string(); }

std::string OutputDirectory::name_within(const std::string& path) const {
  std::error_code error;
  const fs::path folder = fs::path(path).has_parent_path() ? fs::path(path).parent_path() : fs::path(".");
  const bool within = fs::equivalent(folder, path_, error) && !error;
  return within ? fs::path(path).filename().string() : fs::absolute(path).string();
}

}  // namespace carom
