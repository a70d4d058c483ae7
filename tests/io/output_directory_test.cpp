// A run's directory is ready before the run begins, and an earlier run is not overwritten unasked.
#include "carom/io/output_directory.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <vector>

#include "carom/io/directory_lock.hpp"
#include "carom/io/file.hpp"
#include "scratch.hpp"

namespace carom {
namespace {

TEST(OutputDirectory, IsCreatedWithItsParentsAndStaysEmpty) {
  const Scratch scratch;
  const OutputDirectory directory(scratch / "a/b/c");
  EXPECT_TRUE(std::filesystem::is_directory(scratch / "a/b/c"));
  EXPECT_TRUE(std::filesystem::is_empty(scratch / "a/b/c"));
  EXPECT_EQ(directory.report(), scratch / "a/b/c/report.json");
}

TEST(OutputDirectory, RefusesEveryTraceOfARun) {
  for (const std::string name : {"report.json", "scene.toml", "final.xyz", "trajectory.xyz", "trajectory.h5md",
                                 "collisions.csv", "checkpoint.h5"}) {
    const Scratch scratch;
    write_file(scratch / name, "old");
    EXPECT_EQ(message_of([&] { OutputDirectory directory(scratch.path()); }),
              scratch.path() + ": holds a run already (" + name + "): choose another or overwrite it");
    EXPECT_EQ(read_file(scratch / name), "old");
  }
}

TEST(OutputDirectory, OverwritingRemovesTheOldRunAndLeavesOtherFiles) {
  const Scratch scratch;
  write_file(scratch / "trajectory.xyz", "old");
  write_file(scratch / "notes.txt", "mine");
  const OutputDirectory directory(scratch.path(), true);
  EXPECT_TRUE(std::filesystem::exists(scratch / "trajectory.xyz"));  // until the new run is sure to start
  directory.remove_old_run();
  EXPECT_FALSE(std::filesystem::exists(scratch / "trajectory.xyz"));
  EXPECT_EQ(read_file(scratch / "notes.txt"), "mine");
}

TEST(OutputDirectory, OverwritingLeavesNamesThatOnlyLookLikeARuns) {
  const Scratch scratch;
  std::filesystem::create_directory(scratch / "observables");
  for (const std::string name : {"trajectory.csv", "trajectory.mp4", "trajectory.xyz.new-one", "report.json.old",
                                 "observables/mine.csv", "observables/mine.new-table.csv"}) {
    write_file(scratch / name, "mine");
  }
  const OutputDirectory directory(scratch.path());  // nor do they make it one
  directory.remove_unfinished_files();
  directory.remove_old_run();
  EXPECT_EQ(scratch.entries(), 5U);
  EXPECT_TRUE(std::filesystem::exists(scratch / "observables/mine.csv"));
  EXPECT_TRUE(std::filesystem::exists(scratch / "observables/mine.new-table.csv"));
}

TEST(OutputDirectory, WhatAKilledRunLeavesHalfWrittenIsNoRunAndGoes) {
  for (const bool indexed : {false, true}) {
    const Scratch scratch;
    std::filesystem::create_directory(scratch / "observables");
    if (indexed) write_file(scratch / "observables/index.json", "{}");
    const std::vector<std::string> unfinished{"trajectory.h5md.new-77", "report.json.new-77-1",
                                              "observables/msd.csv.new-77-2", "observables/index.json.new-77-3"};
    for (const std::string& name : unfinished) write_file(scratch / name, "half");
    write_file(scratch / ".carom-trial", "carom writes here\n");
    const OutputDirectory directory(scratch.path(), indexed);
    directory.remove_unfinished_files();
    for (const std::string& name : unfinished) EXPECT_FALSE(std::filesystem::exists(scratch / name)) << name;
    EXPECT_EQ(scratch.entries(), 1U);
    EXPECT_EQ(std::filesystem::exists(scratch / "observables/index.json"), indexed);
    directory.remove_old_run();
    EXPECT_EQ(std::filesystem::exists(scratch / "observables"), !indexed);
  }
}

/// What another run leaves while this one waits is seen: nothing is decided before the directory is locked.
TEST(OutputDirectory, LooksForARunUnderItsLock) {
  const Scratch scratch;
  write_file(scratch / "report.json", "old");
  const DirectoryLock lock(scratch.path());
  EXPECT_EQ(message_of([&] { OutputDirectory directory(scratch.path()); }),
            scratch.path() + ": another carom is at work here");
}

TEST(OutputDirectory, RefusesAFileInItsPlace) {
  const Scratch scratch;
  write_file(scratch / "a", "x");
  EXPECT_EQ(message_of([&] { OutputDirectory directory(scratch / "a"); }),
            scratch / "a" + ": is not a directory: the output needs one");
  EXPECT_NE(message_of([&] { OutputDirectory directory(scratch / "a/b"); }).find("cannot be created"),
            std::string::npos);
}

TEST(OutputDirectory, RefusesWhatItCannotWriteTo) {
  const Scratch scratch;
  chmod(scratch.path().c_str(), 0755);
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;  // root may write anywhere
    if (getuid() == 0) {
      if (setgid(kNobody) != 0 || setuid(kNobody) != 0) _exit(3);
    } else {
      chmod(scratch.path().c_str(), 0555);
    }
    try {
      OutputDirectory directory(scratch.path());
    } catch (const Error& error) {
      _exit(std::string(error.what()).find("no file can be written here") == std::string::npos ? 2 : 0);
    }
    _exit(1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

}  // namespace
}  // namespace carom
