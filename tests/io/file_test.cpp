// A file is replaced whole or not at all, and no failure to read or write goes unnoticed.
#include "carom/io/file.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>

#include "scratch.hpp"

namespace carom {
namespace {

/// Runs `action` in a child process; returns what it returned, or 99 if it threw something unexpected.
int in_child(const std::function<int()>& action) {
  const pid_t child = fork();
  if (child == 0) {
    int result = 99;
    try {
      result = action();
    } catch (...) {
    }
    _exit(result);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 98;
}

/// No file may grow beyond so many bytes, as if the disk were full.
void limit_file_size(rlim_t bytes) {
  signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_FSIZE, &limit);
}

/// Whether `action` throws an Error whose message has all these parts.
int refuses_with(const std::function<void()>& action, std::initializer_list<std::string_view> parts) {
  try {
    action();
  } catch (const Error& error) {
    const std::string message = error.what();
    for (const std::string_view part : parts) {
      if (message.find(part) == std::string::npos) return 2;
    }
    return 0;
  }
  return 1;
}

TEST(File, ReadsBackWhatWasWritten) {
  const Scratch scratch;
  const std::string text("a\0b\n\xff", 5);
  write_file(scratch / "a", text);
  EXPECT_EQ(read_file(scratch / "a"), text);
  write_file(scratch / "a", "");
  EXPECT_EQ(read_file(scratch / "a"), "");
  EXPECT_EQ(scratch.entries(), 1u);
}

TEST(File, RefusesToReadWhatIsMissingOrADirectory) {
  const Scratch scratch;
  EXPECT_EQ(message_of([&] { read_file(scratch / "none"); }),
            scratch / "none" + ": cannot be read: No such file or directory");
  EXPECT_EQ(message_of([&] { read_file(scratch.path()); }), scratch.path() + ": cannot be read: it is a directory");
}

TEST(File, NewFilesHonourTheUmaskAndOldOnesKeepTheirMode) {
  const Scratch scratch;
  const mode_t before = umask(027);
  write_file(scratch / "a", "x");
  umask(before);
  struct stat about {};
  ASSERT_EQ(stat((scratch / "a").c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777, 0640u);
  chmod((scratch / "a").c_str(), 0604);
  write_file(scratch / "a", "y");
  ASSERT_EQ(stat((scratch / "a").c_str(), &about), 0);
  EXPECT_EQ(about.st_mode & 0777, 0604u);
}

TEST(File, ALinkKeepsPointingToTheFileThatIsReplaced) {
  const Scratch scratch;
  write_file(scratch / "a", "old");
  std::filesystem::create_symlink(scratch / "a", scratch / "link");
  write_file(scratch / "link", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(scratch / "link"));
  EXPECT_EQ(read_file(scratch / "a"), "new");
}

TEST(File, AFullDiskLeavesTheOldFileAndNothingElse) {
  const Scratch scratch;
  write_file(scratch / "a", "old");
  const int result = in_child([&] {
    limit_file_size(1000);
    return refuses_with([&] { write_file(scratch / "a", std::string(5000, 'x')); }, {scratch / "a", "File too large"});
  });
  EXPECT_EQ(result, 0);
  EXPECT_EQ(read_file(scratch / "a"), "old");
  EXPECT_EQ(scratch.entries(), 1u);
}

TEST(File, AFullDeviceIsReported) {
  EXPECT_EQ(refuses_with([] { write_file("/dev/full", "x"); }, {"/dev/full", "No space left on device"}), 0);
}

TEST(File, AnUnwritableFolderIsReported) {
  const Scratch scratch;
  write_file(scratch / "a", "old");
  const int result = in_child([&] {
    constexpr uid_t kNobody = 65534;  // root may write anywhere
    if (getuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) return 3;
    chmod(scratch.path().c_str(), 0555);
    return refuses_with([&] { write_file(scratch / "b", "new"); }, {scratch / "b", "Permission denied"});
  });
  EXPECT_EQ(result, 0);
  EXPECT_EQ(read_file(scratch / "a"), "old");
}

TEST(File, AMissingFolderIsReported) {
  const Scratch scratch;
  EXPECT_EQ(message_of([&] { write_file(scratch / "no/a", "x"); }),
            scratch / "no/a" + ": cannot be written: No such file or directory");
}

TEST(File, APipeIsNotOpenedToProveThatItCanBe) {
  const Scratch scratch;
  ASSERT_EQ(mkfifo((scratch / "pipe").c_str(), 0600), 0);
  const int result = in_child([&] {
    alarm(3);  // to open it is to wait for its reader
    prove_appendable(scratch / "pipe");
    return 0;
  });
  EXPECT_EQ(result, 0);
}

TEST(OutputStream, HoldsEverythingAfterClose) {
  const Scratch scratch;
  OutputStream stream(scratch / "a");
  std::string expected;
  for (int k = 0; k < 300000; ++k) {
    stream.write("0123456789");
    expected += "0123456789";
  }
  stream.close();
  EXPECT_EQ(read_file(scratch / "a"), expected);
}

TEST(OutputStream, AFullDiskIsReportedByFlushAndByClose) {
  const Scratch scratch;
  for (const bool close : {false, true}) {
    const int result = in_child([&] {
      limit_file_size(1000);
      OutputStream stream(scratch / "a");
      stream.write(std::string(5000, 'x'));
      return refuses_with([&] { close ? stream.close() : stream.flush(); }, {scratch / "a", "File too large"});
    });
    EXPECT_EQ(result, 0);
  }
}

TEST(OutputStream, ABrokenPipeIsReported) {
  const int result = in_child([] {
    signal(SIGPIPE, SIG_IGN);
    int ends[2];
    if (pipe(ends) != 0) return 3;
    OutputStream stream("/dev/fd/" + std::to_string(ends[1]));
    close(ends[0]);
    stream.write("x");
    return refuses_with([&] { stream.close(); }, {"/dev/fd/", "Broken pipe"});
  });
  EXPECT_EQ(result, 0);
}

}  // namespace
}  // namespace carom
