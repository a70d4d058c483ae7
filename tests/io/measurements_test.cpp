// Measurements are written such that every number reads back to the same bits, and every file is in the index.
#include "carom/io/measurements.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "carom/base/error.hpp"
#include "carom/io/file.hpp"
#include "scratch.hpp"

namespace carom {
namespace {

std::vector<Measurement> two() {
  Measurement first{.name = "pressure"};
  first.estimates.push_back({.name = "Z",
                             .unit = "",
                             .value = 9.12934,
                             .error = 0.0017,
                             .samples = 100,
                             .blocks = 25,
                             .correlation_time = 0.5,
                             .theory = 9.13,
                             .theory_source = "someone"});
  first.estimates.push_back({.name = "short", .unit = "1/time", .value = std::nan(""), .warnings = {"too short"}});
  Measurement second{.name = "rdf"};
  second.tables.push_back(
      {.name = "rdf",
       .title = "g(r)",
       .columns = {{"r", "distance r", "length", {1, 1.0 / 3}}, {"g", "g(r)", "", {0.1, std::nan("")}}},
       .logarithmic_x = true});
  second.warnings = {"a general one"};
  return {first, second};
}

TEST(Measurements, TablesHaveAHeaderAndAllDigits) {
  EXPECT_EQ(table_csv(two()[1].tables[0]), "r,g\n1,0.10000000000000001\n0.33333333333333331,nan\n");
  EXPECT_EQ(table_csv({.name = "t", .title = "", .columns = {{"x", "", "", {}}}}), "x\n");
}

TEST(Measurements, EstimatesAreJson) {
  const auto json = nlohmann::json::parse(measurements_json(two()));
  const auto& z = json["pressure"][0];
  EXPECT_EQ(z["value"].get<double>(), 9.12934);
  EXPECT_EQ(z["error"].get<double>(), 0.0017);
  EXPECT_EQ(z["blocks"], 25);
  EXPECT_EQ(z["theory_source"], "someone");
  EXPECT_TRUE(json["pressure"][1]["value"].is_null());
  EXPECT_EQ(json["pressure"][1]["warnings"], nlohmann::json::array({"too short"}));
  EXPECT_TRUE(json["rdf"].empty());
}

TEST(Measurements, AreTextForPeople) {
  EXPECT_EQ(measurements_text(two()),
            "Observables\n"
            "  pressure             Z = 9.1293(17), theory 9.13 (someone)\n"
            "                       short = nan 1/time\n"
            "                       warning: short: too short\n"
            "  rdf                  warning: a general one\n"
            "                       table rdf\n");
}

TEST(Measurements, FilesAndIndexAgree) {
  const Scratch scratch;
  const std::string directory = scratch / "a/b";
  write_measurements(two(), directory);
  const auto index = nlohmann::json::parse(read_file(directory + "/index.json"))["observables"];
  ASSERT_EQ(index.size(), 2U);
  const auto& table = index[1]["tables"][0];
  EXPECT_EQ(read_file(directory + '/' + table["file"].get<std::string>()), table_csv(two()[1].tables[0]));
  EXPECT_EQ(table["columns"][0]["label"], "distance r");
  EXPECT_EQ(table["logarithmic_x"], true);
  EXPECT_EQ(table["bars"], false);
  EXPECT_EQ(index[1]["warnings"][0], "a general one");
  EXPECT_THROW(write_measurements(two(), directory + "/rdf.csv"), Error);
}

}  // namespace
}  // namespace carom
