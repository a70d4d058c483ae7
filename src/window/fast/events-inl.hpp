// The loop over a window's events: predict, take the earliest, apply the rule, predict again.
//
// Included by a file that defines `Kernel` in namespace carom::fast::CAROM_TARGET and the macros CAROM_TARGET,
// CAROM_INLINE, CAROM_BEGIN and CAROM_END.

CAROM_BEGIN
namespace carom::fast::CAROM_TARGET {

template <bool kOneKind>
class Events {
 public:
  explicit Events(Workspace& work)
      : work_(work),
        records_(work.records.data()),
        lists_(*work.lists),
        calendar_(work.calendar),
        size_(work.system.box.size),
        wraps_x_(work.system.box.periodic(0)),
        wraps_y_(work.system.box.periodic(1)),
        elastic_(work.system.physics.elastic()),
        length_(work.length),
        leash_(work.lists->leash()),
        leash_squared_(work.lists->leash_squared()),
        mass_(work.mass(0)),
        sigma_(records_[0].radius + records_[0].radius) {}

  bool predict_all(const std::atomic<bool>& interrupt) {
    const Index count = static_cast<Index>(work_.records.size());
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

  bool process(double until, const std::atomic<bool>& interrupt) {
    std::vector<Due>& due = calendar_.due();
    for (;;) {
      if (due.empty()) {
        if (!calendar_.turn(work_.records)) return true;
        prefetch_ahead();
      }
      const Due event = due.back();
      if (!(event.time < until)) return true;
      if (interrupt.load(std::memory_order_relaxed)) return false;
      if (due.size() > 1 && due[due.size() - 2].time == event.time && settle_tie()) continue;
      due.pop_back();
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
      if (records_[partner].events != lists_[k].partner_events) {
        predict(k);  // the partner has met somebody else since
      } else {
        collide(k, partner, time);
      }
    } else if (partner == kGridEvent) {
      work_.renew_list(k, time);
      predict(k);
    } else {
      if (work_.collide_with_wall(k, time)) work_.renew_list(k, time);
      predict(k);
    }
  }

  CAROM_INLINE void predict(Index k) {
    find_next(k);
    if (records_[k].next < length_) calendar_.push(k, records_[k].next);
  }

  /// Finds the earliest event of disk k and writes it into its record.
  CAROM_INLINE void find_next(Index k) {
    Record& own = records_[k];
    List& list = lists_[k];
    double time;
    Index partner;
    if (list.traits == 0) {
      const Nearest nearest = Kernel::template nearest<kOneKind>(records_, k, list);
      if (nearest.tied) {
        settle(k, time, partner);
      } else {
        time = nearest.time;
        partner = nearest.partner;
      }
    } else {
      settle(k, time, partner);
    }
    const double leaves = leaves_list(own, list, time);
    if (leaves <= time) {
      time = leaves;
      partner = kGridEvent;
    }
    if (!(time < length_)) {
      time = predict::kNever;
      partner = kNobody;
    }
    own.next = time;
    own.partner = partner;
    if (partner >= 0) list.partner_events = records_[partner].events;
  }

  /// The way for lists of any kind.
  void settle(Index k, double& time, Index& partner) {
    const Contact contact = work_.earliest_contact(k);
    time = contact.time;
    partner = contact.partner;
    if (partner >= 0 && (lists_[k].traits & List::kLong) != 0) lists_.set_partner_image(k, contact.key.image);
  }

  /// When the disk has gone as far from its list's centre as it may; kNever if not before `time` or the window's end.
  CAROM_INLINE double leaves_list(const Record& own, const List& list, double time) const {
    const double limit = (time < length_ ? time : length_) - own.t;
    const double ex = own.x - list.x;
    const double ey = own.y - list.y;
    const double px = ex + own.vx * limit;
    const double py = ey + own.vy * limit;
    if (px * px + py * py < leash_squared_) return predict::kNever;
    const double v_squared = own.vx * own.vx + own.vy * own.vy;
    if (!(v_squared > 0)) return predict::kNever;
    const double b = ex * own.vx + ey * own.vy;
    const double c = leash_squared_ - (ex * ex + ey * ey);
    if (c <= 0 && b >= 0) return own.t;
    const double root = std::sqrt(std::max(b * b + v_squared * c, 0.0));
    return own.t + (b > 0 ? c / (b + root) : (root - b) / v_squared);
  }

  CAROM_INLINE void collide(Index first, Index second, double time) {
    Index i = first;
    Index j = second;
    if (work_.ids[j] < work_.ids[i]) std::swap(i, j);
    Record& a = records_[i];
    Record& b = records_[j];
    std::uint32_t generation = 0;
    if (a.t == time || b.t == time) generation = work_.next_generation(i, j, time);

    Image image = lists_.partner_image(first);
    const Image image_before = image;
    bool folded_a = carry(i, time);
    bool folded_b = carry(j, time);
    if (folded_a || folded_b) {
      const Image turns_a = folded_a ? work_.fold(i) : Image{};
      const Image turns_b = folded_b ? work_.fold(j) : Image{};
      image = {image.x + turns_b.x - turns_a.x, image.y + turns_b.y - turns_a.y};
      folded_a = turns_a != Image{};
      folded_b = turns_b != Image{};
    }

    double restitution = 1;
    if (!elastic_) {
      const double last = std::max(work_.last_contact[i], work_.last_contact[j]);
      restitution = work_.restitution_at(time, last, work_.system.physics.restitution);
      work_.last_contact[i] = time;
      work_.last_contact[j] = time;
    }
    const double m_i = kOneKind ? mass_ : work_.mass(i);
    const double m_j = kOneKind ? mass_ : work_.mass(j);
    const double sigma = kOneKind ? sigma_ : a.radius + b.radius;
    const DiskEncounter encounter =
        encounter_of_disks(a.flight(), b.flight(), shift_of(image, size_), m_i, m_j, restitution);
    a.vx = encounter.after.first.x;
    a.vy = encounter.after.first.y;
    b.vx = encounter.after.second.x;
    b.vy = encounter.after.second.y;
    ++a.events;
    ++b.events;

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
      work_.log->push_back(
          row_of_disks(time, generation, work_.ids[i], work_.ids[j], image_before, {a.x, a.y}, a.radius, encounter));
    }
    if (folded_a) work_.renew_list(i, time);
    if (folded_b) work_.renew_list(j, time);
    predict(i);
    predict(j);
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

  void prefetch_ahead() const {}

  Workspace& work_;
  Record* records_;
  Lists& lists_;
  Calendar& calendar_;
  const Vec2 size_;
  const bool wraps_x_, wraps_y_, elastic_;
  const double length_;
  const double leash_, leash_squared_;
  const double mass_;   // where all disks are of one kind
  const double sigma_;  // the same
};

template <bool kOneKind>
bool process_events_of(Workspace& work, double until, const std::atomic<bool>& interrupt) {
  Events<kOneKind> events(work);
  if (!work.predicted && !events.predict_all(interrupt)) return false;
  return events.process(until, interrupt);
}

bool process_events(Workspace& work, double until, const std::atomic<bool>& interrupt) {
  if (work.records.empty()) return true;
  return work.one_kind ? process_events_of<true>(work, until, interrupt)
                       : process_events_of<false>(work, until, interrupt);
}

}  // namespace carom::fast::CAROM_TARGET
CAROM_END
