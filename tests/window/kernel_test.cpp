// Property: every instruction set predicts contacts with the bits of predict::contact_of_disks, in any number at once,
// for copies on either side of a pair; and a window's first events are the earliest of those contacts.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <set>

#include "carom/state/scene.hpp"
#include "hard_flights.hpp"
#include "scenes.hpp"
#include "simd_parameter.hpp"
#include "window/fast/loops.hpp"
#include "window/fast/workspace.hpp"

namespace carom::fast {
namespace {

std::uint64_t bits_of(double number) { return std::bit_cast<std::uint64_t>(number); }

constexpr std::size_t kTenMillion = 10'000'000;

/// As many as a block can hold, and all smaller numbers.
int count_of_block(std::size_t block) { return 1 + static_cast<int>(block * 37 % Company::kMost); }

class Kernel : public ForEverySimd {};
INSTANTIATE_TEST_SUITE_P(Simd, Kernel, every_simd(), test_name_of);

TEST_P(Kernel, HasTheBitsOfContactOfDisksInTenMillionPairs) {
  const Loops loops = loops_for(GetParam(), Neighbourhood::lists, false);
  HardFlights flights(21);
  Company company;
  std::array<double, Company::kMost + Company::kPadding> times;
  std::size_t done = 0;
  for (std::size_t block = 0; done < kTenMillion; ++block) {
    flights.draw(company, count_of_block(block));
    loops.contact_times(company.records.data(), company.own, company.near.data(), company.count, company.shifts,
                        times.data());
    for (int m = 0; m < company.count; ++m) {
      const double expected = company.contact_time(m);
      ASSERT_EQ(bits_of(times[m]), bits_of(expected)) << "block " << block << ", candidate " << m << " of "
                                                      << company.count << ": " << times[m] << " for " << expected;
    }
    done += static_cast<std::size_t>(company.count);
  }
}

TEST(Kernels, AreOneForEveryInstructionSet) {
  std::set<void (*)(const Record*, Index, const Index*, int, const Shifts&, double*)> kernels;
  for (const Simd simd : available_simd()) {
    kernels.insert(loops_for(simd, Neighbourhood::lists, true).contact_times);
    EXPECT_EQ(loops_for(simd, Neighbourhood::lists, true).contact_times,
              loops_for(simd, Neighbourhood::cells, false).contact_times);
  }
  EXPECT_EQ(kernels.size(), available_simd().size()) << "one stands in for another";
}

/// How often each of the formula's branches is taken, and how close to its edge.
struct Branches {
  int parting = 0, abreast = 0, at_rest = 0;
  int at_once = 0, touching_exactly = 0, touching_nearly = 0, touching_and_passing = 0;
  int missing = 0, grazing_exactly = 0, grazing_nearly = 0;
  int meeting = 0;

  void count(const predict::Flight& i, const predict::Flight& j, Vec2 shift, double sigma) {
    const Vec2 r = predict::separation(i, j, shift, std::max(i.time, j.time));
    const Vec2 v = j.velocity - i.velocity;
    const double b = dot(r, v);
    const double c = dot(r, r) - sigma * sigma;
    const double reach = dot(v, v) * (sigma * sigma);
    const double d = reach - cross(r, v) * cross(r, v);
    at_rest += v == Vec2{};
    abreast += b == 0 && v != Vec2{};
    if (!(b < 0)) {
      ++parting;
      return;
    }
    touching_exactly += c == 0;
    touching_and_passing += c == 0 && d < 0;
    touching_nearly += std::abs(c) < 0x1p-48 * sigma * sigma;
    at_once += c <= 0;
    if (c <= 0) return;
    grazing_exactly += d == 0 && reach > 0;
    grazing_nearly += std::abs(d) < 0x1p-48 * reach;
    missing += !(d >= 0);
    meeting += d >= 0;
  }
};

TEST(HardFlights, TakeEveryBranchAndItsEdges) {
  HardFlights flights(22);
  Company company;
  Branches branches;
  int copies = 0;
  for (std::size_t block = 0; block < 5000; ++block) {
    flights.draw(company, count_of_block(block));
    for (int m = 0; m < company.count; ++m) {
      const Record& i = company.records[company.own_is_first[m] ? company.own : company.near[m]];
      const Record& j = company.records[company.own_is_first[m] ? company.near[m] : company.own];
      branches.count(i.flight(), j.flight(), shift_of(company.shifts.images[m], company.size), i.radius + j.radius);
      copies += company.shifts.images[m] != Image{};
    }
  }
  EXPECT_GT(branches.parting, 30'000);
  EXPECT_GT(branches.meeting, 10'000);
  EXPECT_GT(branches.missing, 5'000);
  EXPECT_GT(branches.at_once, 5'000);
  EXPECT_GT(branches.at_rest, 1'000);
  EXPECT_GT(branches.abreast, 300);
  EXPECT_GT(branches.touching_exactly, 300);
  EXPECT_GT(branches.touching_nearly, 1'000);
  EXPECT_GT(branches.touching_and_passing, 10);
  EXPECT_GT(branches.grazing_exactly, 300);
  EXPECT_GT(branches.grazing_nearly, 1'000);
  EXPECT_GT(copies, 50'000);
}

// --- the first events of a window -----------------------------------------------------------------------------

/// A window opened and predicted, none of its events processed.
class Predicted {
 public:
  Predicted(const Scene& scene, const SolverOptions& options, double window)
      : setup_(realize(scene)),
        start_(initial_state(setup_)),
        books_(setup_.system.size()),
        work(setup_.system, options) {
    start_.clock.length = window;
    work.open(start_, books_, nullptr);
    const Neighbourhood neighbourhood = work.cells ? Neighbourhood::cells : Neighbourhood::lists;
    EXPECT_TRUE(!options.neighbourhood || *options.neighbourhood == neighbourhood);
    const Loops loops = loops_for(*options.simd, neighbourhood, work.one_kind);
    EXPECT_TRUE(loops.process_events(work, 0, std::atomic<bool>(false)));
  }

 private:
  Setup setup_;
  State start_;
  Books books_;

 public:
  Workspace work;
};

/// Expects each disk's record to hold its earliest contact, or a grid event that comes no later. Returns the number of
/// contacts.
int expect_first_events(const Workspace& work) {
  int contacts = 0;
  for (Index k = 0; k < static_cast<Index>(work.records.size()); ++k) {
    const Record& own = work.records[k];
    const Contact earliest = work.earliest_contact(k);
    if (!(own.next < work.length)) {
      EXPECT_EQ(earliest.time, predict::kNever) << "disk " << k;
      continue;
    }
    if (own.partner == kGridEvent) {
      EXPECT_LE(own.next, earliest.time) << "disk " << k;
      continue;
    }
    EXPECT_EQ(own.partner, earliest.partner) << "disk " << k;
    EXPECT_EQ(bits_of(own.next), bits_of(earliest.time)) << "disk " << k;
    if (own.partner < 0) continue;
    ++contacts;
    EXPECT_EQ(work.partner_image(k), earliest.key.image) << "disk " << k;
  }
  return contacts;
}

/// What a grid's places know besides the records: contacts that come after a crossing.
void expect_contacts_in_places(const Workspace& work) {
  for (Index k = 0; k < static_cast<Index>(work.records.size()); ++k) {
    const Contact earliest = work.earliest_contact(k);
    if (!((*work.cells)[k].contact < work.length)) {
      EXPECT_EQ(earliest.time, predict::kNever) << "disk " << k;
      continue;
    }
    EXPECT_EQ(bits_of((*work.cells)[k].contact), bits_of(earliest.time)) << "disk " << k;
    EXPECT_EQ((*work.cells)[k].partner, earliest.partner) << "disk " << k;
  }
}

Scene with_large_disks(Scene scene) {
  GasSpec large;
  large.count = 60;
  large.radius = 0.8;
  large.seed = 5;
  large.start = GasStart::random;
  scene.size = Vec2{70, 70};
  scene.gas[0].packing_fraction = {};
  scene.gas[0].start = GasStart::random;
  scene.gas.insert(scene.gas.begin(), large);
  return scene;
}

/// Equal speeds on a square lattice: contacts with two neighbours at one time.
Scene marching_lattice() {
  Scene scene = test::box_of({40, 40}, Boundary::periodic, Boundary::periodic, {});
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 20; ++column) {
      const double speed = (column + row) % 3 - 1;
      scene.disks.push_back(test::disk({2.0 * column + 1, 2.0 * row + 1}, {speed, column % 2 == 0 ? 0 : speed}));
    }
  }
  return scene;
}

TEST_P(Kernel, FindsTheFirstEventOfEveryDiskOfAWindow) {
  int contacts = 0;
  for (const Neighbourhood neighbourhood : {Neighbourhood::lists, Neighbourhood::cells}) {
    const SolverOptions options{.simd = GetParam(), .neighbourhood = neighbourhood};
    for (const Scene& scene : {test::gas(1500, 0.3), test::gas(1500, 0.6, Boundary::reflecting), test::gas(24, 0.2),
                               test::gas(400, 0.02), with_large_disks(test::gas(900, 0.3)),
                               with_large_disks(test::gas(900, 0.3, Boundary::reflecting)), marching_lattice()}) {
      for (const double window : {0.25, 64.0}) {
        const Predicted predicted(scene, options, window);
        contacts += expect_first_events(predicted.work);
        if (predicted.work.cells) expect_contacts_in_places(predicted.work);
      }
    }
  }
  EXPECT_GT(contacts, 5000);
}

}  // namespace
}  // namespace carom::fast
