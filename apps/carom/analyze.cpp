// carom analyze: observables of a saved trajectory.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "carom/carom.hpp"
#include "command.hpp"
#include "options.hpp"

namespace carom::program {
namespace {

struct AnalyzeOptions {
  std::string path;
  std::vector<ObserveSpec> what;
  std::string csv;
  bool json = false;
};

int analyze_command(const AnalyzeOptions& options) {
  const std::vector<Measurement> found = analyze(options.path, options.what);
  if (!options.csv.empty()) write_measurements(found, options.csv);
  print(options.json ? measurements_json(found) : measurements_text(found));
  return kSuccess;
}

}  // namespace

void add_analyze(CLI::App& app, Action& action) {
  CLI::App* command = add_command(app, "analyze", "Observables of a saved trajectory",
                                  "carom run scenes/gas.toml --until 5 --every 0.25 --out saved --overwrite --quiet\n  "
                                  "carom analyze saved --what msd,speeds");
  const auto options = std::make_shared<AnalyzeOptions>();
  command
      ->add_option("TRAJECTORY", options->path,
                   "an extended XYZ or H5MD file, or the directory of a run that saved one")
      ->required()
      ->type_name("");
  add_observables(*command, "--what", options->what,
                  fmt::format("which observables: {}; all by default", fmt::join(observables_of_frames(), ", ")));
  add_path(*command, "--csv", options->csv, "DIR", "write tables and index.json to this directory");
  command->add_flag("--json", options->json, "print one JSON object");
  command->callback([options, &action] { action = [options] { return analyze_command(*options); }; });
}

}  // namespace carom::program
