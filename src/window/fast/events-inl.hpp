// The loop over a window's events: predict, take the earliest, apply the rule, predict again.
//
// Included by a file that defines `TargetKernel` in namespace carom::fast::CAROM_TARGET and the macros CAROM_TARGET,
// CAROM_INLINE, CAROM_BEGIN and CAROM_END.
#include "near-inl.hpp"

CAROM_BEGIN
namespace carom::fast::CAROM_TARGET {

template <class Kernel, class Near, bool kOneKind>
class Events {
 public:
  explicit Events(Workspace& work)
      : work_(work),
        records_(work.records.data()),
        near_(work),
        calendar_(work.calendar),
        size_(work.system.box.size),
        wraps_x_(work.system.box.periodic(0)),
        wraps_y_(work.system.box.periodic(1)),
        elastic_(work.system.physics.elastic()),
        length_(work.length),
        mass_(work.mass(0)),
        sigma_(records_[0].radius + records_[0].radius) {}

  bool predict_all(const std::atomic<bool>& interrupt) {
    const Index count = static_cast<Index>(work_.records.size());
    calendar_.stop();
    for (Index& k = work_.first_unpredicted; k < count; ++k) {
      if (interrupt.load(std::memory_order_relaxed)) return false;
      find_next(k);
    }
    work_.start_calendar();
    for (Index k = 0; k < count; ++k) {
      if (records_[k].next < length_) calendar_.push(k, records_[k].next);
    }
    work_.predicted = true;
    return true;
  }

  /// At the window's end: notes the overlaps of all disks with their neighbours.
  void note_overlaps() {
    const Index count = static_cast<Index>(work_.records.size());
    for (Index k = 0; k < count; ++k) {
      Candidates near;
      if (near_.gather(k, near) != Look::plain ||
          Kernel::template overlap<kOneKind>(records_, k, near.disks.data(), near.size)) {
        work_.note_overlaps_of(k);
      }
    }
  }

  /// Why processing stopped.
  enum class End { reached, interrupted, lists_widened };

  End process(double until, const std::atomic<bool>& interrupt) {
    for (;;) {
      if (calendar_.empty()) {
        if (!calendar_.turn(work_.records)) return End::reached;
        prefetch();
      }
      const Due event = calendar_.first();
      if (!(event.time < until)) return End::reached;
      if (interrupt.load(std::memory_order_relaxed)) return End::interrupted;
      if (work_.lists_are_narrow()) {
        work_.widen_lists(event.time);
        if (!work_.predicted) return End::lists_widened;
      }
      if (calendar_.is_tied() && settle_tie()) continue;
      calendar_.drop_first();
      if (records_[event.disk].next == event.time) process_event(event.disk, event.time);
    }
  }

 private:
  bool settle_tie() {
    return calendar_.settle_tie(work_.records, [&](Index a, Index b) { return work_.key_of(a) < work_.key_of(b); });
  }

  CAROM_INLINE void process_event(Index k, double time) {
    const Index partner = records_[k].partner;
    if (partner >= 0) {
      if (records_[partner].events != near_.partner_events(k)) {
        predict(k);  // the partner has met somebody else since
      } else {
        collide(k, partner, time);
      }
    } else if (partner == kGridEvent) {
      if (near_.grid_event(k, time)) {
        enter(k);
      } else {
        predict(k);
      }
    } else {
      const Image turns = work_.collide_with_wall(k, time);
      if (turns != Image{}) near_.folded(k, turns, time);
      predict(k);
    }
  }

  /// Finds the earliest event of disk k and enters it in the calendar.
  CAROM_INLINE void predict(Index k) {
    find_next(k);
    enter(k);
  }

  CAROM_INLINE void enter(Index k) {
    if (records_[k].next < length_) calendar_.push(k, records_[k].next);
  }

  /// Finds the earliest event of disk k and writes it into its record.
  CAROM_INLINE void find_next(Index k) {
    Candidates near;
    const Look look = near_.gather(k, near);
    if (look == Look::plain) {
      note(k, Kernel::template nearest<kOneKind>(records_, k, near.disks.data(), near.size));
    } else if (look == Look::closer || !find_among_copies(k, near)) {
      give_up(k);
      near_.note(k, work_.settled_contact(k));
    }
  }

  /// Returns false if a closer look is needed.
  bool find_among_copies(Index k, Candidates& near) {
    Shifts shifts;
    if (!near_.shift(k, near, shifts)) return false;
    int which = 0;
    const Nearest nearest =
        Kernel::template nearest_copy<kOneKind>(records_, k, near.disks.data(), near.size, shifts, which);
    if (nearest.tied) return false;
    give_up(k);
    if (nearest.time < length_) near_.set_partner_image(k, shifts.images[which]);
    near_.note(k, nearest);
    return true;
  }

  CAROM_INLINE void note(Index k, const Nearest& nearest) {
    give_up(k);
    near_.note(k, nearest.tied ? work_.settled_contact(k) : nearest);
  }

  /// Before the event of disk k is replaced: its partner, if the calendar counts on k for both, is entered by itself.
  CAROM_INLINE void give_up(Index k) {
    const Record& own = records_[k];
    if (!(own.next < calendar_.due_before()) || own.partner < 0) return;
    const Record& other = records_[own.partner];
    if (other.partner == k && other.next == own.next) calendar_.push(own.partner, other.next);
  }

  [[gnu::flatten]] void collide(Index first, Index second, double time) {
    // Without a branch: which id is smaller cannot be guessed.
    const bool in_order = work_.ids[first] < work_.ids[second];
    const Index i = choose(in_order, first, second);
    const Index j = choose(in_order, second, first);
    // This event is being taken; it is not one that somebody else counts on.
    Record& other = records_[second];
    other.next = choose((other.partner == first) & (other.next == time), predict::kNever, other.next);
    records_[first].next = predict::kNever;
    std::uint32_t generation = 0;
    if (records_[i].t == time || records_[j].t == time) generation = work_.next_generation(i, j, time);

    Image image = work_.partner_image(first);
    const Image image_before = image;
    const bool outside_i = carry(i, time);
    const bool outside_j = carry(j, time);
    if constexpr (Kernel::kSideBySide) {
      if (!outside_i && !outside_j && collide_side_by_side(i, j, time, generation, image)) return;
    }
    if (outside_i || outside_j) {
      const Image turns_i = outside_i ? work_.fold(i) : Image{};
      const Image turns_j = outside_j ? work_.fold(j) : Image{};
      image = {image.x + turns_j.x - turns_i.x, image.y + turns_j.y - turns_i.y};
      const DiskEncounter encounter = part(i, j, time, image);
      book(i, j, time, generation, image_before, encounter);
      if (turns_i != Image{}) near_.folded(i, turns_i, time);
      if (turns_j != Image{}) near_.folded(j, turns_j, time);
    } else {
      const DiskEncounter encounter = part(i, j, time, image);
      book(i, j, time, generation, image_before, encounter);
    }
    predict(i);
    predict(j);
  }

  /// The collision and both predictions with their steps interleaved, so that one need not wait for the other. Returns
  /// false, with nothing done, where one of the disks needs a closer look.
  CAROM_INLINE bool collide_side_by_side(Index i, Index j, double time, std::uint32_t generation, Image image) {
    Candidates near_i, near_j;
    if (near_.gather(i, near_i) != Look::plain || near_.gather(j, near_j) != Look::plain) return false;
    const auto others_i = Kernel::flights_of(records_, near_i.disks.data());
    const auto others_j = Kernel::flights_of(records_, near_j.disks.data());
    const DiskEncounter encounter = part(i, j, time, image);
    if (!(rule::approach(encounter.r, encounter.after) >= 0)) {
      book(i, j, time, generation, image, encounter);
      predict(i);
      predict(j);
      return true;
    }
    auto times_i = Kernel::template times_of<kOneKind>(Kernel::flights_of(records_[i]), others_i);
    auto times_j = Kernel::template times_of<kOneKind>(Kernel::flights_of(records_[j]), others_j);
    times_i = Kernel::without(times_i, near_i.disks.data(), j);
    times_j = Kernel::without(times_j, near_j.disks.data(), i);
    Nearest nearest_i = Kernel::nearest_of(times_i, near_i.disks.data());
    Nearest nearest_j = Kernel::nearest_of(times_j, near_j.disks.data());
    book(i, j, time, generation, image, encounter);
    rest(i, near_i, nearest_i);
    rest(j, near_j, nearest_j);
    note(i, nearest_i);
    note(j, nearest_j);
    enter(i);
    enter(j);
    return true;
  }

  /// The disks beyond the first pass.
  CAROM_INLINE void rest(Index k, const Candidates& near, Nearest& nearest) {
    constexpr int kDone = Kernel::kLanesPerPass;
    if (near.size <= kDone) return;
    nearest =
        earlier(nearest, Kernel::template nearest<kOneKind>(records_, k, near.disks.data() + kDone, near.size - kDone));
  }

  /// Applies the rule to disks i and j, both at the time of contact.
  CAROM_INLINE DiskEncounter part(Index i, Index j, double time, Image image) {
    Record& a = records_[i];
    Record& b = records_[j];
    double restitution = 1;
    if (!elastic_) {
      const double last = std::max(work_.last_contact[i], work_.last_contact[j]);
      restitution = work_.restitution_at(time, last, work_.system.physics.restitution);
      work_.last_contact[i] = time;
      work_.last_contact[j] = time;
    }
    const DiskEncounter encounter =
        kOneKind ? encounter_of_equal_disks(a.flight(), b.flight(), shift_of(image, size_), mass_, restitution)
                 : encounter_of_disks(a.flight(), b.flight(), shift_of(image, size_), work_.mass(i), work_.mass(j),
                                      restitution);
    a.vx = encounter.after.first.x;
    a.vy = encounter.after.first.y;
    b.vx = encounter.after.second.x;
    b.vy = encounter.after.second.y;
    ++a.events;
    ++b.events;
    return encounter;
  }

  CAROM_INLINE void book(Index i, Index j, double time, std::uint32_t generation, Image image,
                         const DiskEncounter& encounter) {
    const double sigma = kOneKind ? sigma_ : records_[i].radius + records_[j].radius;
    const double virial = encounter.impulse * sigma;
    work_.virial[i] += 0.5 * virial;
    work_.virial[j] += 0.5 * virial;
    ++work_.collisions;
    const double distance_squared = dot(encounter.r, encounter.r);
    if constexpr (kOneKind) {
      work_.least_distance_squared = std::min(work_.least_distance_squared, distance_squared);
    } else if (distance_squared < sigma * sigma) {
      work_.note_overlap((sigma - length(encounter.r)) / sigma);
    }
    if (work_.log != nullptr) {
      work_.log->push_back(row_of_disks(time, generation, work_.ids[i], work_.ids[j], image,
                                        {records_[i].x, records_[i].y}, records_[i].radius, encounter));
    }
  }

  /// Free flight to `time`. Returns true if the position has to be folded into the box.
  CAROM_INLINE bool carry(Index k, double time) {
    Record& own = records_[k];
    const double dt = time - own.t;
    own.x = own.x + own.vx * dt;
    own.y = own.y + own.vy * dt;
    own.t = time;
    // What lies inside stays as it is, to the bit.
    return (wraps_x_ && !(own.x > 0 && own.x < size_.x)) || (wraps_y_ && !(own.y > 0 && own.y < size_.y));
  }

  /// Asks for the lines that the events now due will read, and for those that have to be there to ask the same at the
  /// next turn.
  void prefetch() const {
    calendar_.peek(1, [&](Index k) {
      __builtin_prefetch(&records_[k]);
      near_.prefetch(k);
    });
    calendar_.for_due([&](Index k) {
      near_.prefetch(std::max(records_[k].partner, 0));
      near_.prefetch_around(k);
    });
  }

  Workspace& work_;
  Record* records_;
  Near near_;
  Calendar& calendar_;
  const Vec2 size_;
  const bool wraps_x_, wraps_y_, elastic_;
  const double length_;
  const double mass_;   // where all disks are of one kind
  const double sigma_;  // the same
};

template <template <class, bool> class Near, bool kOneKind>
struct LoopsOf {
  using EventsHere = Events<TargetKernel, Near<TargetKernel, kOneKind>, kOneKind>;

  static bool process_events(Workspace& work, double until, const std::atomic<bool>& interrupt) {
    for (;;) {
      EventsHere events(work);
      if (!work.predicted && !events.predict_all(interrupt)) return false;
      const auto end = events.process(until, interrupt);
      if (end != EventsHere::End::lists_widened) return end == EventsHere::End::reached;
    }
  }
  static void note_overlaps(Workspace& work) { EventsHere(work).note_overlaps(); }
};

template <template <class, bool> class Near>
Loops loops_near(bool one_kind) noexcept {
  return one_kind ? Loops{LoopsOf<Near, true>::process_events, LoopsOf<Near, true>::note_overlaps,
                          TargetKernel::contact_times}
                  : Loops{LoopsOf<Near, false>::process_events, LoopsOf<Near, false>::note_overlaps,
                          TargetKernel::contact_times};
}

Loops loops(Neighbourhood neighbourhood, bool one_kind) noexcept {
  return neighbourhood == Neighbourhood::cells ? loops_near<NearFromCells>(one_kind)
                                               : loops_near<NearFromLists>(one_kind);
}

}  // namespace carom::fast::CAROM_TARGET
CAROM_END
