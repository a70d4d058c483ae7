// A checkpoint comes back bit for bit, and no damaged or foreign file passes for one.
#include "carom/io/checkpoint.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <thread>
#include <vector>

#include "carom/base/random.hpp"
#include "carom/io/file.hpp"
#include "hdf5/trial.hpp"
#include "scenes.hpp"
#include "scratch.hpp"

namespace carom {
namespace {

Checkpoint some_checkpoint(double restitution = 0.9, Boundary boundary = Boundary::reflecting) {
  Scene scene = test::gas(20, 0.4, boundary);
  scene.restitution = restitution;
  Simulation simulation(realize(scene));
  simulation.measure_from(0.5);
  simulation.run_until(7.7);
  Checkpoint checkpoint;
  checkpoint.snapshot = simulation.snapshot();
  checkpoint.settings.until = 0.0;
  checkpoint.settings.collisions = 12345;
  checkpoint.settings.every = 0.1;
  checkpoint.settings.equilibrate = 0.5;
  checkpoint.settings.trajectory = TrajectoryFormat::h5md;
  checkpoint.title = "a \"title\"\nof two lines";
  checkpoint.scene_digest = "0123456789abcdef";
  checkpoint.files = {.frames = 7, .trajectory_bytes = 1'000'000, .log = "collisions.csv", .log_bytes = 99};
  checkpoint.quiet_windows = 3;
  checkpoint.wall_seconds = 1.0 / 3;
  checkpoint.sums = {{"msd/counts", std::vector<std::int64_t>{-1, 1LL << 60}},
                     {"pressure.x/sum", std::vector<double>{0.1, -0.0, 1e-310}},
                     {"empty", std::vector<double>{}}};
  checkpoint.start = checkpoint.snapshot.state.disks;
  return checkpoint;
}

TEST(Checkpoint, ComesBackBitForBit) {
  for (const double restitution : {1.0, 0.9}) {
    for (const Boundary boundary : {Boundary::periodic, Boundary::reflecting, Boundary::open}) {
      const Checkpoint written = some_checkpoint(restitution, boundary);
      const std::string bytes = checkpoint_bytes(written);
      const Checkpoint read = parse_checkpoint(bytes, "c.h5");
      EXPECT_EQ(checkpoint_bytes(read), bytes);
      EXPECT_EQ(read.snapshot.state.disks.x, written.snapshot.state.disks.x);
      EXPECT_EQ(read.snapshot.state.last_contact, written.snapshot.state.last_contact);
      EXPECT_EQ(read.snapshot.state.clock.start, written.snapshot.state.clock.start);
      EXPECT_EQ(read.snapshot.books.wall_impulse_of, written.snapshot.books.wall_impulse_of);
      EXPECT_EQ(read.snapshot.measured.start, written.snapshot.measured.start);
      EXPECT_EQ(read.settings.until, written.settings.until);
      EXPECT_EQ(read.settings.collisions, written.settings.collisions);
      EXPECT_EQ(read.settings.trajectory, written.settings.trajectory);
      EXPECT_EQ(read.title, written.title);
      EXPECT_EQ(read.files.log, written.files.log);
      EXPECT_EQ(read.files.log_bytes, written.files.log_bytes);
      EXPECT_EQ(read.wall_seconds, written.wall_seconds);
      EXPECT_EQ(read.sums, written.sums);
    }
  }
}

TEST(Checkpoint, NoDamageGoesUnnoticed) {
  const std::string bytes = checkpoint_bytes(some_checkpoint());
  RandomStream random(1, 2, 3);
  for (int k = 0; k < 500; ++k) {
    std::string damaged = bytes;
    damaged[random.below(damaged.size())] ^= static_cast<char>(1U << random.below(8));
    EXPECT_THROW(parse_checkpoint(damaged, "c.h5"), Error) << k;
  }
  for (std::size_t size = 0; size < bytes.size(); size += 37) {
    EXPECT_THROW(parse_checkpoint(std::string_view(bytes).substr(0, size), "c.h5"), Error) << size;
  }
  EXPECT_THROW(parse_checkpoint(bytes + "x", "c.h5"), Error);
}

TEST(Checkpoint, TellsWhatIsWrong) {
  EXPECT_EQ(message_of([] { parse_checkpoint("hello", "c.h5"); }), "c.h5: this is not a checkpoint");
  EXPECT_EQ(message_of([] { parse_checkpoint("carom checkpoint\nversion 2\nbytes 1\nxxh3 0\n", "c.h5"); }),
            "c.h5: this checkpoint has format 2, this carom reads formats up to 1: use a newer one");
  EXPECT_EQ(message_of([] { parse_checkpoint("carom checkpoint\nversion x\n", "c.h5"); }),
            "c.h5: the checkpoint is damaged: its head");
}

/// A file is tried in a child process first, which must not wait for threads that only its parent has.
TEST(Checkpoint, AreReadWhileOtherThreadsWrite) {
  const Checkpoint checkpoint = some_checkpoint();
  const std::string bytes = checkpoint_bytes(checkpoint);
  std::atomic<bool> enough{false};
  std::vector<std::thread> writers;
  for (int k = 0; k < 3; ++k) {
    writers.emplace_back([&] {
      while (!enough) EXPECT_EQ(checkpoint_bytes(checkpoint), bytes);
    });
  }
  for (int k = 0; k < 30; ++k) EXPECT_NO_THROW(parse_checkpoint(bytes, "c.h5")) << k;
  enough = true;
  for (std::thread& writer : writers) writer.join();
}

TEST(Checkpoint, OnlyADamagedOneGivesWayToTheOneBefore) {
  const Scratch scratch;
  write_checkpoint(scratch / "b.h5", {}, some_checkpoint());
  const std::vector<std::string> paths{scratch / "a.h5", scratch / "b.h5"};
  EXPECT_EQ(read_newest_checkpoint(paths)->path, paths[1]);
  write_file(paths[0], "x");
  EXPECT_EQ(read_newest_checkpoint(paths)->damaged.size(), 1U);
  std::filesystem::remove(paths[0]);
  std::filesystem::create_directory(paths[0]);
  EXPECT_EQ(message_of([&] { read_newest_checkpoint(paths); }), paths[0] + ": cannot be read: it is a directory");
  std::filesystem::remove(paths[0]);
  std::filesystem::create_symlink("a.h5", paths[0]);
  EXPECT_EQ(message_of([&] { read_newest_checkpoint(paths); }),
            paths[0] + ": cannot be read: Too many levels of symbolic links");
}

TEST(Checkpoint, OneThatCannotBeTriedIsNotTakenForDamaged) {
  const Scratch scratch;
  chmod(scratch.path().c_str(), 0755);
  write_checkpoint(scratch / "a.h5", {}, some_checkpoint());
  const pid_t child = fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;  // root may start any number of processes
    if (getuid() == 0 && (setgid(kNobody) != 0 || setuid(kNobody) != 0)) _exit(3);
    const rlimit none{0, 0};
    setrlimit(RLIMIT_NPROC, &none);
    try {
      read_newest_checkpoint({scratch / "a.h5", scratch / "b.h5"});
    } catch (const io::NotTried&) {
      _exit(0);
    } catch (...) {
      _exit(2);
    }
    _exit(1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

TEST(Checkpoint, ATrialThatIsKilledOrTooLongSaysNothingOfTheFile) {
  EXPECT_THROW(io::try_in_child([] { pause(); }, "c.h5", 0.05), io::NotTried);
  EXPECT_THROW(io::try_in_child([] { raise(SIGKILL); }, "c.h5", 10), io::NotTried);
}

TEST(Checkpoint, TheOneBeforeIsKept) {
  const Scratch scratch;
  Checkpoint checkpoint = some_checkpoint();
  for (const std::uint64_t frames : {1, 2, 3}) {
    checkpoint.files.frames = frames;
    write_checkpoint(scratch / "a.h5", scratch / "b.h5", checkpoint);
  }
  EXPECT_EQ(read_checkpoint(scratch / "a.h5").files.frames, 3U);
  EXPECT_EQ(read_checkpoint(scratch / "b.h5").files.frames, 2U);
  EXPECT_EQ(scratch.entries(), 2U);
}

}  // namespace
}  // namespace carom
