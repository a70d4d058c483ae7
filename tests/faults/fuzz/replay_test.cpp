// No file of the corpus, whole, cut short or with a bit turned, does anything but give a result or an Error.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "carom/base/random.hpp"
#include "carom/io/file.hpp"
#include "readers.hpp"

namespace carom::test {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> corpus_of(const std::string& reader) {
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(fs::path(CAROM_CORPUS) / reader)) {
    files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  return files;
}

class Corpus : public testing::TestWithParam<FuzzedReader> {};

TEST_P(Corpus, IsReadOrRefused) {
  const std::vector<std::string> files = corpus_of(GetParam().name);
  EXPECT_FALSE(files.empty());
  for (const std::string& file : files) GetParam().read(read_file(file));
}

TEST_P(Corpus, CutShortIsReadOrRefused) {
  for (const std::string& file : corpus_of(GetParam().name)) {
    const std::string bytes = read_file(file);
    const std::size_t step = std::max<std::size_t>(1, bytes.size() / 16);
    for (std::size_t size = 0; size < bytes.size(); size += step) GetParam().read(bytes.substr(0, size));
  }
}

TEST_P(Corpus, WithABitTurnedIsReadOrRefused) {
  constexpr int kTurns = 16;
  RandomStream random(7, 0, 1);
  for (const std::string& file : corpus_of(GetParam().name)) {
    const std::string bytes = read_file(file);
    for (int k = 0; k < kTurns && !bytes.empty(); ++k) {
      std::string turned = bytes;
      turned[random.below(bytes.size())] ^= static_cast<char>(1U << random.below(8));
      GetParam().read(turned);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Readers, Corpus, testing::ValuesIn(fuzzed_readers()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace carom::test
