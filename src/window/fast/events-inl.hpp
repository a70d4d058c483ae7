// The loop over a window's events: predict, take the earliest, apply the rule, predict again.
//
// Included by a file that defines `TargetKernel` in namespace carom::fast::CAROM_TARGET and the macros CAROM_TARGET,
// CAROM_INLINE, CAROM_NOINLINE, CAROM_BEGIN and CAROM_END.
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
        plainly_(elastic_ && work.log == nullptr),
        patched_(work.patched),
        far_(work.records.size() > kNear),
        length_(work.length),
        mass_(work.mass(0)),
        sigma_(records_[0].radius + records_[0].radius) {}

  bool predict_all(const std::atomic<bool>& interrupt) {
    const Index count = static_cast<Index>(work_.records.size());
    for (Index& k = work_.first_unpredicted; k < count; ++k) {
      if (interrupt.load(std::memory_order_relaxed)) return false;
      records_[k].partner = kNobody;  // what was predicted before this window is of no interest
      find_next(k);
    }
    work_.start_calendar();
    for (Index k = 0; k < count; ++k) {
      if (records_[k].next < length_ && !(records_[k].partner < k && is_entered_for_partner(k))) {
        calendar_.push(k, records_[k].next);
      }
    }
    work_.predicted = true;
    return true;
  }

  /// At the window's end: notes the overlaps of all disks with their neighbours.
  void note_overlaps() {
    const Index count = static_cast<Index>(work_.records.size());
    for (Index k = 0; k < count; ++k) {
      if (!work_.counts(k)) continue;
      Candidates near;
      if (near_.gather(k, near) != Look::plain ||
          Kernel::template overlap<kOneKind>(records_, k, near.disks, near.size)) {
        work_.note_overlaps_of(k);
      }
    }
    if (work_.system.box.has_walls()) work_.note_overlaps_with_walls();
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
      if (records_[event.disk].next != event.time) continue;
      if (patched_ && is_left_alone(event.disk, event.time)) continue;
      process_event(event.disk, event.time);
    }
  }

 private:
  /// So many disks fit into the fast caches.
  static constexpr std::size_t kNear = 20'000;

  bool settle_tie() {
    return calendar_.settle_tie(work_.records, [&](Index a, Index b) { return work_.key_of(a) < work_.key_of(b); });
  }

  /// In a patch: whether the event is one of the halo's, so late that it can matter to nobody who counts. Such a disk
  /// flies on as it is, until it meets one that is not left alone.
  CAROM_INLINE bool is_left_alone(Index k, double time) {
    if (time <= work_.last_events[k]) return false;
    Record& own = records_[k];
    const Index partner = own.partner;
    const bool met =
        partner >= 0 && time <= work_.last_events[partner] && records_[partner].events == near_.partner_events(k);
    if (!met) own.next = predict::kNever;
    return !met;
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
    const double time = records_[k].next;
    if (time < length_ && !is_entered_for_partner(k)) calendar_.push(k, time);
  }

  /// Whether the event of disk k is its partner's too, so that the calendar needs but one of them.
  [[nodiscard]] CAROM_INLINE bool is_entered_for_partner(Index k) const {
    const Record& own = records_[k];
    const Record& other = records_[std::max(own.partner, 0)];
    return (own.partner >= 0) & (other.partner == k) & (other.next == own.next);
  }

  /// Finds the earliest event of disk k and writes it into its record.
  CAROM_INLINE void find_next(Index k) {
    Candidates near;
    const Look look = near_.gather(k, near);
    if (look == Look::plain) {
      note(k, Kernel::template nearest<kOneKind>(records_, k, near.disks, near.size));
    } else {
      look_closer(k, near, look);
    }
  }

  CAROM_NOINLINE void look_closer(Index k, Candidates& near, Look look) {
    if (look == Look::copies && find_among_copies(k, near)) return;
    give_up(k);
    near_.note(k, work_.settled_contact(k));
  }

  /// Returns false if a closer look is needed.
  bool find_among_copies(Index k, Candidates& near) {
    Shifts shifts;
    if (!near_.shift(k, near, shifts)) return false;
    int which = 0;
    const Nearest nearest = Kernel::template nearest_copy<kOneKind>(records_, k, near.disks, near.size, shifts, which);
    if (nearest.tied) return false;
    give_up(k);
    if (nearest.time < length_) near_.set_partner_image(k, shifts.images[which]);
    near_.note(k, nearest);
    return true;
  }

  CAROM_INLINE void note(Index k, const Nearest& nearest) {
    give_up(k);
    if (nearest.tied) {
      note_tied(k);
    } else {
      near_.note(k, nearest);
    }
  }
  CAROM_NOINLINE void note_tied(Index k) { near_.note(k, work_.settled_contact(k)); }

  /// Before the event of disk k is replaced: if it is its partner's too, the partner is entered by itself.
  CAROM_INLINE void give_up(Index k) {
    const Record& own = records_[k];
    if (own.next < length_ && is_entered_for_partner(k)) calendar_.push(own.partner, own.next);
  }

  CAROM_INLINE void collide(Index first, Index second, double time) {
    // This event is being taken; it is not one that somebody else counts on.
    Record& other = records_[second];
    other.next = choose((other.partner == first) & (other.next == time), predict::kNever, other.next);
    records_[first].next = predict::kNever;
    // Without a branch: which id is smaller cannot be guessed.
    const bool in_order = work_.ids[first] < work_.ids[second];
    const Index i = choose(in_order, first, second);
    const Index j = choose(in_order, second, first);
    const Image image = near_.partner_image(first);
    if constexpr (Kernel::kSideBySide && kOneKind) {
      if (plainly_ && image == Image{} && collide_side_by_side(i, j, time)) return;
    }
    collide_any(i, j, time, image);
  }

  /// The usual contact, with both predictions, whose steps are interleaved so that one need not wait for the other.
  /// Returns false, with nothing done, where one of the disks needs a closer look.
  CAROM_INLINE bool collide_side_by_side(Index i, Index j, double time) {
    Record& a = records_[i];
    Record& b = records_[j];
    Candidates near_i, near_j;
    const Look look_i = near_.gather(i, near_i);
    const Look look_j = near_.gather(j, near_j);
    predict::Flight flight_i = a.flight();
    predict::Flight flight_j = b.flight();
    const bool tied = (a.t == time) | (b.t == time);
    flight_i.position = predict::position_at(flight_i, time);
    flight_j.position = predict::position_at(flight_j, time);
    const int outside =
        static_cast<int>(is_outside(flight_i.position)) | static_cast<int>(is_outside(flight_j.position));
    if (tied || outside != 0 || look_i != Look::plain || look_j != Look::plain) {
      return false;
    }
    const auto others_i = Kernel::template flights_of<kOneKind>(records_, near_i.disks);
    const auto others_j = Kernel::template flights_of<kOneKind>(records_, near_j.disks);
    const DiskEncounter encounter =
        encounter_of_equal_disks(separation_at_contact(flight_i.position, flight_j.position, {}),
                                 {flight_i.velocity, flight_j.velocity}, mass_, 1);
    if (!(rule::approach(encounter.r, encounter.after) >= 0)) return false;
    move(a, flight_i.position, encounter.after.first, time);
    move(b, flight_j.position, encounter.after.second, time);
    auto times_i = Kernel::template times_of<kOneKind>(Kernel::flights_of(a), others_i);
    auto times_j = Kernel::template times_of<kOneKind>(Kernel::flights_of(b), others_j);
    times_i = Kernel::without(times_i, near_i.disks, j);
    times_j = Kernel::without(times_j, near_j.disks, i);
    Nearest nearest_i = Kernel::nearest_of(times_i, near_i.disks);
    Nearest nearest_j = Kernel::nearest_of(times_j, near_j.disks);
    book_equal(i, j, encounter);
    if (patched_) note_histories(i, j, time, {});
    if (near_i.size > Kernel::kLanesPerPass) nearest_i = earlier(nearest_i, nearest_of_rest(i, near_i));
    if (near_j.size > Kernel::kLanesPerPass) nearest_j = earlier(nearest_j, nearest_of_rest(j, near_j));
    note(i, nearest_i);
    enter(i);
    note(j, nearest_j);
    enter(j);
    return true;
  }

  CAROM_INLINE static void move(Record& own, Vec2 position, Vec2 velocity, double time) {
    own.x = position.x;
    own.y = position.y;
    own.vx = velocity.x;
    own.vy = velocity.y;
    own.t = time;
    ++own.events;
  }

  /// Among the candidates beyond the first pass.
  CAROM_NOINLINE Nearest nearest_of_rest(Index k, const Candidates& near) {
    constexpr int kDone = Kernel::kLanesPerPass;
    return Kernel::template nearest<kOneKind>(records_, k, near.disks + kDone, near.size - kDone);
  }

  /// Any contact; both predictions follow.
  CAROM_NOINLINE void collide_any(Index i, Index j, double time, Image image) {
    std::uint32_t generation = 0;
    if (records_[i].t == time || records_[j].t == time) generation = work_.next_generation(i, j, time);
    const Image image_before = image;
    const bool outside_i = carry(i, time);
    const bool outside_j = carry(j, time);
    const Image turns_i = outside_i ? work_.fold(i) : Image{};
    const Image turns_j = outside_j ? work_.fold(j) : Image{};
    image = {image.x + turns_j.x - turns_i.x, image.y + turns_j.y - turns_i.y};
    const DiskEncounter encounter = part(i, j, time, image);
    book(i, j, time, generation, image_before, encounter);
    if (turns_i != Image{}) near_.folded(i, turns_i, time);
    if (turns_j != Image{}) near_.folded(j, turns_j, time);
    predict(i);
    predict(j);
  }

  /// Applies the rule to disks i and j, both at the time of contact.
  CAROM_INLINE DiskEncounter part(Index i, Index j, double time, Image image) {
    Record& a = records_[i];
    Record& b = records_[j];
    double restitution = 1;
    if (!elastic_) {
      const double last = std::max(work_.last_contact[i], work_.last_contact[j]);
      restitution = work_.restitution_at(time, last, work_.system.physics.restitution, work_.counts(i));
      work_.last_contact[i] = time;
      work_.last_contact[j] = time;
    }
    const Vec2 r = separation_at_contact({a.x, a.y}, {b.x, b.y}, shift_of(image, size_));
    const rule::Velocities before{{a.vx, a.vy}, {b.vx, b.vy}};
    const DiskEncounter encounter = kOneKind ? encounter_of_equal_disks(r, before, mass_, restitution)
                                             : encounter_of_disks(r, before, work_.mass(i), work_.mass(j), restitution);
    move(a, {a.x, a.y}, encounter.after.first, time);
    move(b, {b.x, b.y}, encounter.after.second, time);
    return encounter;
  }

  CAROM_INLINE void book_equal(Index i, Index j, const DiskEncounter& encounter) {
    const double virial = encounter.impulse * sigma_;
    work_.virial[i] += 0.5 * virial;
    work_.virial[j] += 0.5 * virial;
    if (!work_.counts(i)) return;
    ++work_.collisions;
    work_.least_distance_squared = std::min(work_.least_distance_squared, dot(encounter.r, encounter.r));
  }

  /// In a patch: what a near copy and its owner compare.
  CAROM_INLINE void note_histories(Index i, Index j, double time, Image image) {
    const auto note = [&](Index k, Index other) {
      const Vec2 velocity{records_[k].vx, records_[k].vy};
      work_.histories[k] = next_history(work_.histories[k], time, work_.ids[other], image, velocity);
    };
    note(i, j);
    note(j, i);
    ++work_.contacts;
    const int roles = static_cast<int>(work_.roles[i]) | static_cast<int>(work_.roles[j]);
    work_.met_far |= roles == (static_cast<int>(Role::owned) | static_cast<int>(Role::far));
  }

  CAROM_INLINE void book(Index i, Index j, double time, std::uint32_t generation, Image image,
                         const DiskEncounter& encounter) {
    if constexpr (kOneKind) {
      book_equal(i, j, encounter);
    } else {
      const double sigma = records_[i].radius + records_[j].radius;
      const double virial = encounter.impulse * sigma;
      work_.virial[i] += 0.5 * virial;
      work_.virial[j] += 0.5 * virial;
      if (work_.counts(i)) {
        ++work_.collisions;
        if (dot(encounter.r, encounter.r) < sigma * sigma) work_.note_overlap((sigma - length(encounter.r)) / sigma);
      }
    }
    if (patched_) note_histories(i, j, time, image);
    if (work_.log != nullptr && work_.counts(i)) {
      work_.log->push_back(row_of_disks(time, generation, work_.ids[i], work_.ids[j], image,
                                        {records_[i].x, records_[i].y}, records_[i].radius, encounter));
    }
  }

  /// Whether the position has to be folded into the box. What lies inside stays as it is, to the bit.
  [[nodiscard]] CAROM_INLINE bool is_outside(Vec2 position) const {
    return (wraps_x_ & !((position.x > 0) & (position.x < size_.x))) |
           (wraps_y_ & !((position.y > 0) & (position.y < size_.y)));
  }

  /// Free flight to `time`. Returns true if the position has to be folded into the box.
  CAROM_INLINE bool carry(Index k, double time) {
    Record& own = records_[k];
    const double dt = time - own.t;
    own.x = own.x + own.vx * dt;
    own.y = own.y + own.vy * dt;
    own.t = time;
    return is_outside({own.x, own.y});
  }

  /// Asks for what the next events will read.
  void prefetch() const {
    if constexpr (Near::kReadsFar) {
      if (far_) {
        prefetch_in_steps();
        return;
      }
    }
    calendar_.peek(1, [&](Index k) {
      __builtin_prefetch(&records_[k]);
      near_.prefetch(k);
    });
    calendar_.for_due([&](Index k) { near_.prefetch(std::max(records_[k].partner, 0)); });
  }

  /// Where the disks do not fit into the cache: each step finds at hand what the one before asked for, a bucket
  /// earlier.
  void prefetch_in_steps() const {
    calendar_.peek(2, [&](Index k) {
      __builtin_prefetch(&records_[k], 1);
      near_.prefetch(k);
    });
    calendar_.peek(1, [&](Index k) {
      const Index partner = records_[k].partner;
      near_.prefetch_around(k, partner);
      if (partner < 0) return;
      __builtin_prefetch(&records_[partner], 1);
      near_.prefetch(partner);
      prefetch_books(k);
      prefetch_books(partner);
    });
    calendar_.for_due([&](Index k) { near_.prefetch_candidates(k, records_[k].partner); });
  }

  void prefetch_books(Index k) const {
    __builtin_prefetch(&work_.virial[k], 1);
    __builtin_prefetch(&work_.ids[k]);
    if (!patched_) return;
    __builtin_prefetch(&work_.histories[k], 1);
    __builtin_prefetch(&work_.last_events[k]);
  }

  Workspace& work_;
  Record* records_;
  Near near_;
  Calendar& calendar_;
  const Vec2 size_;
  const bool wraps_x_, wraps_y_, elastic_;
  const bool plainly_;  // contacts are elastic and nobody asks for them one by one
  const bool patched_;
  const bool far_;  // the disks are too many for the cache
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
                          TargetKernel::contact_times, TargetKernel::list_steps()}
                  : Loops{LoopsOf<Near, false>::process_events, LoopsOf<Near, false>::note_overlaps,
                          TargetKernel::contact_times, TargetKernel::list_steps()};
}

Loops loops(Neighbourhood neighbourhood, bool one_kind) noexcept {
  return neighbourhood == Neighbourhood::cells ? loops_near<NearFromCells>(one_kind)
                                               : loops_near<NearFromLists>(one_kind);
}

}  // namespace carom::fast::CAROM_TARGET
CAROM_END
