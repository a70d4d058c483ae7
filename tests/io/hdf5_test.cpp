// What is written beside the HDF5 library is what the library itself would have written.
#include <gtest/gtest.h>

#include <fstream>

#include "carom/io/file.hpp"
#include "carom/io/trajectory.hpp"
#include "hdf5/growing_file.hpp"
#include "hdf5/rows.hpp"
#include "hdf5/superblock.hpp"
#include "scenes.hpp"
#include "scratch.hpp"

namespace carom {
namespace {

io::Superblock superblock_of(const std::string& path) {
  const std::string bytes = read_file(path);
  io::Superblock block{};
  std::copy_n(bytes.begin(), block.size(), block.begin());
  return block;
}

TEST(Lookup3, HasTheValuesOfItsAuthor) {
  const auto hash = [](std::string_view text) {
    return io::lookup3(reinterpret_cast<const unsigned char*>(text.data()), text.size());
  };
  EXPECT_EQ(hash(""), 0xdeadbeefU);
  EXPECT_EQ(hash("Four score and seven years ago"), 0x17770551U);
}

TEST(Superblock, OfAClosedFileIsAsTheLibraryWritesIt) {
  const Scratch scratch;
  const std::string path = scratch / "a.h5";
  {
    const io::Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110);
    const io::Handle file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.id()), H5Fclose);
    ASSERT_TRUE(file.open());
  }
  const io::Superblock block = superblock_of(path);
  ASSERT_TRUE(io::is_superblock(block));
  EXPECT_EQ(io::end_in(block), std::filesystem::file_size(path));
  EXPECT_EQ(io::closed_superblock(block, io::end_in(block)), block);
  EXPECT_NE(io::closed_superblock(block, io::end_in(block) + 1), block);
}

TEST(Rows, ShuffleSortsBytesBySignificance) {
  const std::vector<unsigned char> bytes{1, 2, 3, 11, 12, 13};
  EXPECT_EQ(io::shuffled(bytes.data(), 3, 2), (std::vector<unsigned char>{1, 11, 2, 12, 3, 13}));
}

TEST(H5md, IsReadWhileItGrows) {
  const Scratch scratch;
  const carom::Setup setup = realize(test::gas(70000, 0.3));
  const std::string path = scratch / "t.h5md";
  const auto writer = create_trajectory(path, TrajectoryFormat::h5md, setup.system);
  EXPECT_FALSE(open_trajectory(path)->skip());
  Frame frame = setup.frame;
  for (int k = 0; k < 3; ++k) {
    frame.time = k;
    frame.winding_x[69999] = -k;
    writer->append(setup.system, frame);
    const auto reader = open_trajectory(path);
    for (int skipped = 0; skipped < k; ++skipped) ASSERT_TRUE(reader->skip());
    const std::optional<carom::Setup> read = reader->next();
    ASSERT_TRUE(read);
    EXPECT_FALSE(reader->next());
    EXPECT_EQ(digest(read->system, read->frame), digest(setup.system, frame));
  }
  writer->cut_to({1, 0});
  EXPECT_EQ(writer->length().frames, 1U);
  writer->close();
  const auto reader = open_trajectory(path);
  EXPECT_TRUE(reader->skip());
  EXPECT_FALSE(reader->skip());
  EXPECT_EQ(scratch.entries(), 1U);
}

TEST(H5md, OfAnotherRunIsNotGoneOnWith) {
  const Scratch scratch;
  const carom::Setup setup = realize(test::gas(20, 0.3));
  const std::string path = scratch / "t.h5md";
  create_trajectory(path, TrajectoryFormat::h5md, setup.system)->append(setup.system, setup.frame);
  const carom::Setup other = realize(test::gas(21, 0.3));
  EXPECT_NE(message_of([&] {
              continue_trajectory(path, TrajectoryFormat::h5md, other.system, {1, 0});
            }).find("of another run"),
            std::string::npos);
  EXPECT_NE(message_of([&] {
              continue_trajectory(path, TrajectoryFormat::h5md, setup.system, {2, 0});
            }).find("shorter than it was"),
            std::string::npos);
}

}  // namespace
}  // namespace carom
