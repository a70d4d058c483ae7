// The pair distribution g(r): how often two disks are at distance r, compared with disks placed at random.
//
// g(r) = (pairs at distances of the bin) / (number of pairs × expected share of an ideal gas): every pair of two disks
// counts with all its periodic images. An ideal gas has g = 1 exactly, for any N, so
// Z = 1 + 2 η g(σ⁺) (N − 1)/N for equal disks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "carom/base/error.hpp"
#include "carom/observe/batches.hpp"
#include "carom/observe/blocking.hpp"
#include "carom/observe/theory.hpp"
#include "carom/order/pairs.hpp"
#include "columns.hpp"
#include "contact.hpp"
#include "estimates.hpp"
#include "ideal_pairs.hpp"
#include "kinds.hpp"

namespace carom {
namespace {

// Mixtures of more kinds have too many partial functions to be read.
constexpr std::size_t kMostKinds = 3;
constexpr double kMeanFreeTimes = 8;
constexpr double kStandardBins = 250;
constexpr double kStandardRange = 5;    // in the largest diameter
constexpr double kShortestRange = 1.5;  // likewise

/// What is counted for two kinds of disks, or for all.
struct Partial {
  std::string suffix;            // "", "_AB"
  std::string label;             // "g(r)", "g(r) of A and B"
  double pairs = 0;              // of disks
  std::vector<double> expected;  // of an ideal gas, by bin
  Batches g;                     // by bin
  std::optional<ContactFit> fit;
  Blocking contact;

  std::vector<double> counted;  // in one frame
  double contact_sum = 0;       // likewise
};

/// Z − 1 over the contact value, where that is the whole virial: equal elastic disks in a periodic box.
std::optional<double> excess_per_contact(const System& system) {
  const bool periodic = system.box.periodic(0) && system.box.periodic(1);
  if (!periodic || !system.physics.elastic() || system.species.size() != 1) return std::nullopt;
  const auto disks = static_cast<double>(system.size());
  return 2 * packing_fraction(system) * (disks - 1) / disks;
}

class Rdf final : public Observable {
 public:
  Rdf(const System& system, double range, std::size_t bins, double interval)
      : interval_(interval),
        range_(range),
        bins_(bins),
        excess_per_contact_(excess_per_contact(system)),
        fluid_(fluid_of_equal_disks(system)),
        count_of_kind_(system.species.size(), 0) {
    for (const std::uint32_t kind : system.species_of) ++count_of_kind_[kind];
    if (system.species.size() <= kMostKinds) add_partials(system);
    if (system.species.size() != 1) add_total(system);
    for (const Partial& partial : partials_) {
      if (partial.fit) reach_ = std::max(reach_, partial.fit->range());
    }
    reach_ = std::max(reach_, range_);
  }

  [[nodiscard]] std::string_view name() const noexcept override { return "rdf"; }
  [[nodiscard]] double interval() const noexcept override { return interval_; }

  void on_frame(const System& system, const Frame& frame) override {
    for (Partial& partial : partials_) {
      partial.counted.assign(bins_, 0);
      partial.contact_sum = 0;
    }
    PairGrid(system.box, frame, reach_).for_each([&](std::size_t i, std::size_t j, Vec2 r) {
      if (i != j) count(system, i, j, length(r));
    });
    for (Partial& partial : partials_) book(partial);
  }

  [[nodiscard]] Measurement result() const override;

  void exchange(SumsExchange sums) override {
    sums.number("interval", interval_);
    for (Partial& partial : partials_) {
      const SumsExchange own = sums.below("g" + partial.suffix);
      partial.g.exchange(own.below("bins"));
      partial.contact.exchange(own.below("contact"));
    }
  }

 private:
  [[nodiscard]] double edge(std::size_t bin) const {
    return range_ * static_cast<double>(bin) / static_cast<double>(bins_);
  }

  void add_partials(const System& system);
  void add_total(const System& system);
  [[nodiscard]] std::vector<double> expected_of(const IdealPairs& ideal) const;

  void count(const System& system, std::size_t i, std::size_t j, double r) {
    const auto bin = static_cast<std::size_t>(r / range_ * static_cast<double>(bins_));
    const std::size_t partial = partial_of(system.species_of[i], system.species_of[j]);
    if (partial < partials_.size()) {
      if (bin < bins_) ++partials_[partial].counted[bin];
      if (r <= partials_[partial].fit->range()) partials_[partial].contact_sum += partials_[partial].fit->weight(r);
    }
    if (total_ && bin < bins_) ++partials_[*total_].counted[bin];
  }

  [[nodiscard]] std::size_t partial_of(std::uint32_t a, std::uint32_t b) const {
    return partial_of_kinds_.empty() ? partials_.size() : partial_of_kinds_[a * count_of_kind_.size() + b];
  }

  void book(Partial& partial) const {
    if (!(partial.pairs > 0)) return;
    for (std::size_t bin = 0; bin < bins_; ++bin) {
      const double expected = partial.pairs * partial.expected[bin];
      partial.g.add(bin, expected > 0 ? partial.counted[bin] / expected : 0);
    }
    partial.g.end_sample();
    if (partial.fit) partial.contact.add(partial.contact_sum / partial.pairs);
  }

  double interval_;
  double range_;
  std::size_t bins_;
  std::optional<double> excess_per_contact_;
  std::optional<EqualDisks> fluid_;
  double reach_ = 0;  // pairs farther apart are of no interest

  std::vector<double> count_of_kind_;
  std::vector<Partial> partials_;
  std::vector<std::size_t> partial_of_kinds_;  // index into partials_ by two kinds; empty if there are too many
  std::optional<std::size_t> total_;           // index of the g(r) of all disks of a mixture
};

std::vector<double> Rdf::expected_of(const IdealPairs& ideal) const {
  std::vector<double> expected;
  for (std::size_t bin = 0; bin < bins_; ++bin) expected.push_back(ideal.between(edge(bin), edge(bin + 1)));
  return expected;
}

void Rdf::add_partials(const System& system) {
  const std::size_t kinds = system.species.size();
  partial_of_kinds_.resize(kinds * kinds);
  for (std::size_t a = 0; a < kinds; ++a) {
    for (std::size_t b = a; b < kinds; ++b) {
      partial_of_kinds_[a * kinds + b] = partial_of_kinds_[b * kinds + a] = partials_.size();
      const double n_a = count_of_kind_[a];
      const double radius_a = system.species[a].radius;
      const double radius_b = system.species[b].radius;
      const IdealPairs ideal(system.box, radius_a, radius_b);
      const char name_a = static_cast<char>('A' + a);
      const char name_b = static_cast<char>('A' + b);
      Partial partial{.suffix = kinds > 1 ? fmt::format("_{}{}", name_a, name_b) : "",
                      .label = kinds > 1 ? fmt::format("g(r) of {} and {}", name_a, name_b) : "g(r)",
                      .pairs = a == b ? n_a * (n_a - 1) / 2 : n_a * count_of_kind_[b],
                      .expected = expected_of(ideal),
                      .g = Batches(bins_),
                      .fit = ContactFit(ideal, radius_a + radius_b, packing_fraction(system)),
                      .contact = {},
                      .counted = {}};
      partials_.push_back(std::move(partial));
    }
  }
}

void Rdf::add_total(const System& system) {
  const auto n = static_cast<double>(system.size());
  double mean_radius = 0;
  for (std::size_t k = 0; k < system.size(); ++k) mean_radius += system.radius(k) / n;
  std::vector<double> expected = expected_of(IdealPairs(system.box, mean_radius, mean_radius));
  if (!partials_.empty()) {  // known better: kinds have different room between walls
    std::fill(expected.begin(), expected.end(), 0);
    for (const Partial& partial : partials_) {
      const double share = partial.pairs / (n * (n - 1) / 2);
      for (std::size_t bin = 0; bin < bins_; ++bin) expected[bin] += share * partial.expected[bin];
    }
  }
  total_ = partials_.size();
  partials_.push_back({.suffix = "",
                       .label = "g(r) of all",
                       .pairs = n * (n - 1) / 2,
                       .expected = std::move(expected),
                       .g = Batches(bins_),
                       .fit = {},
                       .contact = {},
                       .counted = {}});
}

Measurement Rdf::result() const {
  Measurement measurement;
  measurement.name = name();
  Table table{.name = "rdf", .title = "Pair distribution", .columns = {{"r", "distance r", "length", {}}}};
  for (std::size_t bin = 0; bin < bins_; ++bin) {
    table.columns[0].values.push_back((edge(bin) + edge(bin + 1)) / 2);
  }
  for (const Partial& partial : partials_) {
    if (!(partial.pairs > 0)) continue;
    append_columns(table, {"g" + partial.suffix, partial.label, "", {}}, means_of(partial.g));
    if (!partial.fit) continue;
    Estimate& contact = add_estimate(measurement, "contact_value" + partial.suffix, "", partial.contact, interval_);
    if (fluid_) {
      contact.theory = (finite_compressibility(*fluid_) - 1) / *excess_per_contact_;
      contact.theory_source = source_of_compressibility(*fluid_);
    }
    if (!excess_per_contact_) continue;
    Estimate z = scaled(contact, "Z", "", *excess_per_contact_);
    z.value += 1;
    if (fluid_) z.theory = finite_compressibility(*fluid_);
    measurement.estimates.push_back(std::move(z));
  }
  measurement.tables.push_back(std::move(table));
  return measurement;
}

/// As far as five diameters, but not beyond half the box, where images repeat one another.
double standard_range(const System& system) {
  const double diameter = 2 * system.largest_radius();
  const double half_box = std::min(system.box.size.x, system.box.size.y) / 2;
  return std::max(std::min(kStandardRange * diameter, half_box), kShortestRange * diameter);
}

}  // namespace

ObservableKind rdf_kind() {
  return {
      .name = "rdf",
      .summary = "pair distribution g(r) and its contact value",
      .from_frames = true,
      .options =
          {interval_option("8 mean free times"),
           {.name = "r_max",
            .meaning = "largest distance",
            .standard = "5 diameters, at most half the box",
            .least = 1e-300},
           {.name = "bins", .meaning = "number of bins", .standard = "250", .whole = true, .least = 1, .most = 1e5}},
      .make = [](const Subject& subject, const ObservableOptions& options) -> std::unique_ptr<Observable> {
        const System& system = subject.system;
        if (system.box.boundary[0] == Boundary::open || system.box.boundary[1] == Boundary::open) {
          throw Error("rdf: the plane is open: there is no density to compare with");
        }
        if (system.size() < 2) throw Error("rdf: there are no pairs of disks");
        return std::make_unique<Rdf>(system, options.number("r_max", standard_range(system)),
                                     options.count("bins", static_cast<std::size_t>(kStandardBins)),
                                     frame_interval(options, subject, kMeanFreeTimes));
      }};
}

}  // namespace carom
