// Reports and collision logs have the promised keys and columns, and their numbers read back to the same bits.
#include "carom/io/report.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>

#include "carom/io/collisions_csv.hpp"
#include "scratch.hpp"

namespace carom {
namespace {

RunRecord any_record() {
  RunRecord record;
  Summary& summary = record.summary;
  summary.disks = 10;
  summary.packing_fraction = 0.1 + 0.2;
  summary.time = 1.0 / 3;
  summary.collisions = 1000;
  summary.wall_collisions = 7;
  summary.solver = "reference";
  summary.simd = "scalar";
  summary.windows = 3;
  summary.energy_drift = 1e-17;
  summary.temperature = 1;
  summary.digest = "0123456789abcdef";
  record.wall_seconds = 0.5;
  record.scene_digest = "fedcba9876543210";
  record.version = "0.1.0";
  record.command = "carom run \"a b\" \xff";
  record.compiler = "GCC 12.2";
  return record;
}

TEST(ReportJson, HasThePromisedKeysInOrder) {
  const auto report = nlohmann::ordered_json::parse(report_json(any_record()));
  std::string keys;
  for (const auto& [key, value] : report.items()) keys += key + ' ';
  EXPECT_EQ(keys,
            "disks packing_fraction time collisions wall_collisions wall_seconds collisions_per_second threads patches "
            "solver simd windows windows_repaired ties collapses max_overlap energy_drift momentum_drift temperature "
            "pressure digest scene_digest version command compiler patches_repaired duplicated_work phase_seconds "
            "observables ");
}

TEST(ReportJson, NumbersReadBackAndWhatIsAbsentIsNull) {
  RunRecord record = any_record();
  record.summary.energy_drift = std::numeric_limits<double>::quiet_NaN();
  const auto report = nlohmann::json::parse(report_json(record));
  EXPECT_EQ(report["packing_fraction"].get<double>(), 0.1 + 0.2);
  EXPECT_EQ(report["time"].get<double>(), 1.0 / 3);
  EXPECT_EQ(report["collisions"], 1000);
  EXPECT_EQ(report["collisions_per_second"], 2000.0);
  EXPECT_TRUE(report["pressure"].is_null());
  EXPECT_TRUE(report["momentum_drift"].is_null());
  EXPECT_TRUE(report["energy_drift"].is_null());
  record.wall_seconds = 0;
  EXPECT_TRUE(nlohmann::json::parse(report_json(record))["collisions_per_second"].is_null());
}

TEST(ReportText, NamesWhatARunIsJudgedBy) {
  RunRecord record = any_record();
  record.summary.ties = 2;
  const std::string text = report_text(record);
  for (const char* part : {"disks             10\n", "ties              2", "largest overlap", "energy drift",
                           "0123456789abcdef", "fedcba9876543210"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " in\n" << text;
  }
  EXPECT_EQ(text.find("NOT TO BE TRUSTED"), std::string::npos);
  EXPECT_EQ(text.find("pressure"), std::string::npos);
  record.summary.max_overlap = 0.1;
  EXPECT_NE(report_text(record).find("NOT TO BE TRUSTED"), std::string::npos);
}

TEST(CollisionsCsv, HasOneRowPerCollisionWith17Digits) {
  const Scratch scratch;
  CollisionsCsv csv(scratch / "c.csv");
  Collision pair;
  pair.time = 0.1;
  pair.i = 3;
  pair.j = 5;
  pair.point = {1.0 / 3, 2};
  pair.normal = {1, -0.0};
  pair.impulse = 0.7;
  Collision wall = pair;
  wall.j = id_of(Wall::top);
  csv.append(std::vector{pair, wall}, 2.0);
  csv.append({}, 4.0);
  csv.append(std::vector{pair}, 4.0);
  csv.close();
  const std::string rest = ",0.33333333333333331,2,1,-0,0.69999999999999996\n";
  EXPECT_EQ(read_file(scratch / "c.csv"), "time,i,j,x,y,nx,ny,impulse\n2.1000000000000001,3,5" + rest +
                                              "2.1000000000000001,3,top" + rest + "4.0999999999999996,3,5" + rest);
}

TEST(CollisionsCsv, AFullDiskIsReported) {
  CollisionsCsv csv("/dev/full");
  EXPECT_EQ(message_of([&] { csv.close(); }), "/dev/full: cannot be written: No space left on device");
}

}  // namespace
}  // namespace carom
