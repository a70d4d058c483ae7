// Property: the calendar gives events in the order of time, none lost and none twice, whatever the width of its buckets
// and the size of its ring, while disks' events are replaced by earlier and later ones.
#include "window/fast/calendar.hpp"

#include <gtest/gtest.h>

#include <compare>
#include <optional>
#include <random>
#include <set>

namespace carom::fast {
namespace {

/// An event of one disk (first = second) or of two.
struct Event {
  double time = 0;
  Index first = 0;
  Index second = 0;

  friend auto operator<=>(const Event&, const Event&) = default;
};

struct Shape {
  double length = 1;  ///< of the window
  double width = 1;   ///< of a bucket
  std::size_t ring = 1;

  friend std::ostream& operator<<(std::ostream& out, const Shape& shape) {
    return out << "length " << shape.length << ", width " << shape.width << ", ring " << shape.ring;
  }
};

/// Uses a calendar as a solver does, and keeps the same events in a tree.
class Diary {
 public:
  Diary(std::size_t disks, const Shape& shape) : length_(shape.length), records_(disks, kAtRest) {
    calendar_.start(shape.length, shape.width, shape.ring);
  }

  /// From now on the disk's next event comes at `time`, if that is within the window.
  void enter(Index k, double time) {
    withdraw(k);
    note(k, time, kNobody);
    if (time < length_) calendar_.push(k, time);
  }

  /// The same for two disks that meet.
  void enter_contact(Index i, Index j, double time) {
    withdraw(i);
    withdraw(j);
    note(i, time, j);
    note(j, time, i);
    if (time < length_) calendar_.push(i, time);  // once for both
  }

  /// From now on the disk meets the same partner at `time`, which nobody tells the partner.
  void move_contact(Index k, double time) {
    const Index partner = records_[k].partner;
    withdraw(k);
    note(k, time, partner);
    if (time < length_) calendar_.push(k, time);
  }

  /// The earliest event by the calendar, which then is no more; nothing at the window's end.
  std::optional<Event> take() {
    for (;;) {
      if (calendar_.empty() && !calendar_.turn(records_)) return std::nullopt;
      const Due due = calendar_.first();
      if (calendar_.is_tied() &&
          calendar_.settle_tie(records_, [&](Index a, Index b) { return event_of(a) < event_of(b); })) {
        continue;
      }
      calendar_.drop_first();
      if (records_[due.disk].next != due.time) continue;
      const Event event = event_of(due.disk);
      records_[event.first] = records_[event.second] = kAtRest;
      return event;
    }
  }

  /// The earliest event by the tree, which then is no more.
  std::optional<Event> take_expected() {
    if (expected_.empty()) return std::nullopt;
    const Event event = *expected_.begin();
    expected_.erase(expected_.begin());
    return event;
  }

  [[nodiscard]] std::size_t waiting() const { return expected_.size(); }

 private:
  static constexpr Record kAtRest{0, 0, 0, 0, 0, 0.5, predict::kNever, kNobody, 0};

  [[nodiscard]] bool is_contact(Index k) const {
    const Index partner = records_[k].partner;
    return partner >= 0 && records_[partner].partner == k && records_[partner].next == records_[k].next;
  }
  [[nodiscard]] Event event_of(Index k) const {
    const Index other = is_contact(k) ? records_[k].partner : k;
    return {records_[k].next, std::min(k, other), std::max(k, other)};
  }
  void note(Index k, double time, Index partner) {
    records_[k].next = time < length_ ? time : predict::kNever;
    records_[k].partner = time < length_ ? partner : kNobody;
    if (time < length_) expected_.insert(event_of(k));
    if (is_contact(k)) expected_.erase({time, partner, partner});  // it was entered for the first disk alone
  }
  /// The disk's event is no more. A partner's goes on without it, as long as nobody has told the partner.
  void withdraw(Index k) {
    const Event event = event_of(k);
    if (event.time == predict::kNever) return;
    expected_.erase(event);
    const bool contact = is_contact(k);
    const Index partner = records_[k].partner;
    if (contact) calendar_.push(partner, event.time);
    records_[k] = kAtRest;
    if (contact) expected_.insert(event_of(partner));
  }

  double length_;
  Array<Record> records_;
  std::set<Event> expected_;
  Calendar calendar_;
};

/// Times at which new events come: many at the very same time, some soon, some far ahead.
class Future {
 public:
  Future(std::uint64_t seed, const Shape& shape, double mean) : random_(seed), length_(shape.length), mean_(mean) {}

  std::size_t below(std::size_t bound) { return random_() % bound; }
  double after(double now) {
    switch (below(16)) {
      case 0: return now;
      case 1: return now + length_ * uniform();
      case 2: return now + 1e-9 * mean_ * uniform();
      case 3:
      case 4: return std::ceil(now / length_ * 64 + static_cast<double>(below(4))) * length_ / 64;  // ties
      case 5: return std::nextafter(length_, 0);
      case 6: return predict::kNever;
      default: return now - mean_ * std::log1p(-uniform());
    }
  }

 private:
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

  std::mt19937_64 random_;
  double length_;
  double mean_;
};

constexpr std::size_t kMostEvents = 600;

/// One window: events are taken, each is followed by others, and now and then a bystander's is replaced. Returns how
/// many were taken.
std::size_t play(std::size_t disks, const Shape& shape, std::uint64_t seed) {
  Diary diary(disks, shape);
  Future future(seed, shape, shape.length * static_cast<double>(disks) / kMostEvents);
  const auto any = [&] { return static_cast<Index>(future.below(disks)); };
  const auto change = [&](Index k, double now) {
    const Index other = any();
    if (other != k && future.below(2) == 0) {
      diary.enter_contact(k, other, future.after(now));
    } else {
      diary.enter(k, future.after(now));
    }
  };
  for (Index k = 0; k < static_cast<Index>(disks); ++k) change(k, 0);
  for (std::size_t taken = 0;; ++taken) {
    const std::optional<Event> expected = diary.take_expected();
    const std::optional<Event> event = diary.take();
    EXPECT_EQ(event.has_value(), expected.has_value())
        << "after " << taken << " events, " << diary.waiting() << " wait";
    if (!event || !expected) return taken;
    EXPECT_TRUE(*event == *expected) << "event " << taken << " of " << event->first << " and " << event->second
                                     << " at " << event->time << ", not of " << expected->first << " and "
                                     << expected->second << " at " << expected->time;
    if (testing::Test::HasFailure()) return taken;
    if (taken > 2 * kMostEvents) continue;  // no new ones: so that the end comes
    change(event->first, event->time);
    if (event->second != event->first) change(event->second, event->time);
    if (future.below(3) == 0) change(any(), event->time);
    if (future.below(3) == 0) diary.move_contact(any(), future.after(event->time));
  }
}

TEST(Calendar, GivesEventsInTheOrderOfTimeWhateverItsShape) {
  std::uint64_t seed = 0;
  for (const double length : {1024.0, 0x1.5p-20}) {
    for (const double buckets : {0.3, 1.0, 1.99, 3.7, 16.0, 64.0, 1000.1, 3e5}) {
      for (const std::size_t ring : {1, 2, 3, 7, 64, 5000}) {
        const Shape shape{length, length / buckets, ring};
        SCOPED_TRACE(testing::Message() << shape);
        std::size_t taken = 0;
        for (const std::size_t disks : {1, 2, 40, 400}) {
          taken += play(disks, shape, ++seed);
          if (HasFailure()) return;
        }
        EXPECT_GT(taken, 600U);
      }
    }
  }
}

/// Records of disks whose only event comes at these times.
Array<Record> records_at(std::initializer_list<double> times) {
  Array<Record> records;
  for (const double time : times) records.push_back({0, 0, 0, 0, 0, 0.5, time, kNobody, 0});
  return records;
}

std::vector<Index> due_of(const Calendar& calendar) {
  std::vector<Index> due;
  calendar.for_due([&](Index k) { due.push_back(k); });
  std::sort(due.begin(), due.end());
  return due;
}

TEST(Calendar, DropsWhatIsOutOfDateWhenItsTurnComes) {
  Array<Record> records = records_at({0.75, predict::kNever, 0.1});
  Calendar calendar;
  calendar.start(1, 0.5, 2);
  for (const Index k : {0, 1, 2}) calendar.push(k, 0.2);
  calendar.push(0, 0.75);
  ASSERT_TRUE(calendar.turn(records));
  EXPECT_EQ(due_of(calendar), (std::vector<Index>{2}));
  EXPECT_EQ(calendar.first().time, 0.1) << "the time is the record's";
  calendar.drop_first();
  ASSERT_TRUE(calendar.turn(records));
  EXPECT_EQ(due_of(calendar), (std::vector<Index>{0}));
}

TEST(Calendar, KeepsManyEventsOfOneBucketInOrder) {
  Array<Record> records;
  for (int k = 0; k < 1000; ++k) records.push_back({0, 0, 0, 0, 0, 0.5, (k * 617 % 1000) / 1000.0, kNobody, 0});
  for (const double width : {10.0, 0.5, 0.3}) {
    Calendar calendar;
    calendar.start(1, width, 2);
    for (Index k = 0; k < 1000; ++k) calendar.push(k, records[k].next);
    int taken = 0;
    while (!calendar.empty() || calendar.turn(records)) {
      EXPECT_EQ(calendar.first().time, taken / 1000.0);
      calendar.drop_first();
      ++taken;
    }
    EXPECT_EQ(taken, 1000);
    EXPECT_GE(calendar.pushed(), 1000U);
  }
}

TEST(Calendar, IsEmptyWhenStartedAgain) {
  const Array<Record> records = records_at({0.1, 0.2, 0.9});
  Calendar calendar;
  calendar.start(1, 0.125, 3);
  for (Index k = 0; k < 3; ++k) calendar.push(k, records[k].next);
  ASSERT_TRUE(calendar.turn(records));
  calendar.start(1, 0.125, 3);
  EXPECT_TRUE(calendar.empty());
  EXPECT_EQ(calendar.pushed(), 0U);
  EXPECT_FALSE(calendar.turn(records));
}

}  // namespace
}  // namespace carom::fast
