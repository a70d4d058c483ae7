#include "bin_samples.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

#include "carom/base/error.hpp"

namespace carom {
namespace {

using Direction = SumsExchange::Direction;

SavedSums saved(Blocking& bin) {
  SavedSums sums;
  bin.exchange(SumsExchange(sums, Direction::save));
  return sums;
}

/// Appends the arrays of one bin to those of all, and notes how long each is.
void join(SavedSums& all, std::vector<std::int64_t>& lengths, const SavedSums& bin) {
  for (const auto& entry : bin) {
    std::visit(
        [&](const auto& numbers) {
          using Numbers = std::decay_t<decltype(numbers)>;
          auto& joined = std::get<Numbers>(all.try_emplace(entry.first, Numbers{}).first->second);
          joined.insert(joined.end(), numbers.begin(), numbers.end());
          lengths.push_back(static_cast<std::int64_t>(numbers.size()));
        },
        entry.second);
  }
}

/// Takes one bin's arrays from those of all, where the last bin's ended.
class Splitter {
 public:
  Splitter(const SavedSums& all, const std::vector<std::int64_t>& lengths) : all_(all), lengths_(lengths) {}

  SavedSums next() {
    SavedSums bin;
    for (const auto& entry : all_) {
      const std::int64_t length = length_++ < lengths_.size() ? lengths_[length_ - 1] : -1;
      std::int64_t& from = taken_[entry.first];
      std::visit(
          [&](const auto& numbers) {
            using Numbers = std::decay_t<decltype(numbers)>;
            if (length < 0 || from + length > static_cast<std::int64_t>(numbers.size())) {
              throw Error("sums are damaged: '" + entry.first + "' of the bins is too short");
            }
            bin[entry.first] = Numbers(numbers.begin() + from, numbers.begin() + from + length);
          },
          entry.second);
      from += length;
    }
    return bin;
  }

 private:
  const SavedSums& all_;
  const std::vector<std::int64_t>& lengths_;
  std::size_t length_ = 0;
  std::map<std::string, std::int64_t> taken_;
};

}  // namespace

void BinSamples::add(const std::vector<double>& samples) {
  for (std::size_t bin = 0; bin < bins_.size(); ++bin) bins_[bin].add(samples[bin]);
}

void BinSamples::append_to(std::vector<Column>& columns, const Column& heading) const {
  Column means = heading;
  Column errors{heading.name + "_error", "standard error of " + heading.label, heading.unit, {}};
  for (const Blocking& bin : bins_) {
    const Blocking::Result result = bin.result();
    means.values.push_back(result.mean);
    errors.values.push_back(result.error.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  columns.push_back(std::move(means));
  columns.push_back(std::move(errors));
}

void BinSamples::exchange(SumsExchange sums) {
  SavedSums all;
  std::vector<std::int64_t> lengths;
  if (sums.loading()) {
    Blocking empty;  // has the names
    all = saved(empty);
  } else {
    for (Blocking& bin : bins_) join(all, lengths, saved(bin));
  }
  for (auto& entry : all) {
    std::visit([&](auto& numbers) { sums.numbers(entry.first, numbers); }, entry.second);
  }
  sums.numbers("lengths", lengths);
  if (!sums.loading()) return;
  Splitter splitter(all, lengths);
  for (Blocking& bin : bins_) {
    SavedSums one = splitter.next();
    bin.exchange(SumsExchange(one, Direction::load));
  }
}

}  // namespace carom
