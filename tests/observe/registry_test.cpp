// Observables are made by name and options; what is wrong is told with its place and with what was probably meant.
#include "carom/observe/registry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

#include "carom/base/error.hpp"
#include "carom/observe/observable_set.hpp"
#include "scenes.hpp"

namespace carom {
namespace {

std::string message_of(const std::vector<ObserveSpec>& specs, const Scene& scene = test::gas(10, 0.2),
                       std::optional<double> spacing = {}) {
  const carom::Setup setup = realize(scene);
  try {
    const ObservableSet set(specs, {setup.system, setup.frame, spacing});
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST(Registry, NamesAreInOrderAndMakeWhatTheyName) {
  const carom::Setup setup = realize(test::gas(10, 0.2));
  const carom::Setup walled = realize(test::gas(10, 0.2, Boundary::reflecting));
  std::string before;
  for (const ObservableKind& kind : observable_kinds()) {
    EXPECT_LT(before, kind.name);
    before = kind.name;
    EXPECT_FALSE(kind.summary.empty());
    const bool needs_walls = kind.name == "wall_pressure";
    const carom::Setup& chosen = needs_walls ? walled : setup;
    const auto made = make_observable({std::string(kind.name)}, {chosen.system, chosen.frame});
    EXPECT_EQ(made->name(), kind.name);
    EXPECT_EQ(made->result().name, kind.name) << "a result without a single window";
  }
}

TEST(Registry, KnowsTheNearestName) {
  EXPECT_EQ(message_of({{.name = "presure", .place = {"a.toml", 3, 1}}}),
            "a.toml:3:1: unknown observable 'presure': did you mean 'pressure'?");
  EXPECT_NE(message_of({{.name = "qqqqqqqqqqqqqqqqqqqqqqq"}}).find("the known ones are"), std::string::npos);
}

TEST(Registry, RefusesUnknownOptionsWithTheirPlace) {
  const ObserveSpec spec{
      .name = "pressure", .options = {{"bins", 3}}, .places = {{"bins", {"a.toml", 4, 1}}}, .place = {"a.toml", 3, 1}};
  EXPECT_EQ(message_of({spec}), "a.toml:4:1: unknown option 'bins' of pressure: there is none");
}

TEST(Registry, RefusesOneNameTwiceAndTellsAllAtOnce) {
  const std::string message = message_of({{.name = "pressure"}, {.name = "pressure"}, {.name = "nothing-like-it"}});
  EXPECT_NE(message.find("the observable 'pressure' is asked for twice"), std::string::npos);
  EXPECT_NE(message.find("unknown observable 'nothing-like-it'"), std::string::npos);
}

TEST(Registry, RefusesWhatTheSystemDoesNotHave) {
  const std::string message =
      message_of({{.name = "pressure", .place = {"a.toml", 9, 1}}}, test::gas(10, 0.2, Boundary::open));
  EXPECT_EQ(message, "a.toml:9:1: pressure: the plane is open, nothing keeps the disks together");
}

TEST(Registry, RefusesWhatFramesDoNotTell) {
  EXPECT_EQ(message_of({{.name = "pressure"}}, test::gas(10, 0.2), 1.0),
            "pressure needs every collision of a run; it cannot be had from frames");
}

TEST(Registry, IntervalsArePowersOfTwoNearTheMeanFreeTime) {
  const carom::Setup setup = realize(test::gas(100, 0.3));
  const ObserveSpec plain{.name = "any"};
  const double interval = frame_interval(ObservableOptions(plain), {setup.system, setup.frame}, 1);
  EXPECT_EQ(interval, 0.25);  // Γ = 2.4
  EXPECT_EQ(frame_interval(ObservableOptions(plain), {setup.system, setup.frame, 0.3}, 1), 0.3);
  const ObserveSpec told{.name = "any", .options = {{"interval", 0.7}}};
  EXPECT_EQ(frame_interval(ObservableOptions(told), {setup.system, setup.frame}, 1), 0.7);
  EXPECT_THROW(frame_interval(ObservableOptions(told), {setup.system, setup.frame, 0.3}, 1), Error);
}

}  // namespace
}  // namespace carom
