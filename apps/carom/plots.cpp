// carom plot: what a run or a sweep found, as pictures.
#include "plots.hpp"

#include "carom/carom.hpp"
#include "command.hpp"
#ifdef CAROM_HAS_DRAW
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <system_error>

#include "carom/carom/plots.hpp"
#include "options.hpp"
#endif

namespace carom::program {
#ifdef CAROM_HAS_DRAW
namespace {

namespace fs = std::filesystem;

const std::map<std::string, PictureFormat> kFormats{
    {"svg", PictureFormat::svg}, {"png", PictureFormat::png}, {"pdf", PictureFormat::pdf}};
const std::vector<std::string> kUsualFormats{"svg", "png"};

struct PlotOptions {
  std::string directory;
  std::string out;
  std::vector<std::string> formats;
  std::vector<std::string> names;
  bool json = false;
};

/// Each plot in each format; the names of the files.
std::vector<std::string> write_plots(const std::vector<NamedPlot>& plots, const std::string& out,
                                     const std::vector<std::string>& formats) {
  std::error_code error;
  fs::create_directories(out, error);
  if (error) throw Error("cannot be created: " + error.message(), {out});
  std::vector<std::string> written;
  for (const NamedPlot& named : plots) {
    for (const std::string& format : formats) {
      const std::string path = (fs::path(out) / (named.name + '.' + format)).string();
      write_file(path, picture_of_plot(named.plot, kFormats.at(format)));
      written.push_back(path);
    }
  }
  return written;
}

std::string out_or_plots(const std::string& directory, const std::string& out) {
  return out.empty() ? (fs::path(directory) / "plots").string() : out;
}

/// The plots of that name, or all that show what is called so. Throws Error that names what there is.
std::vector<NamedPlot> named(const std::vector<NamedPlot>& plots, const std::vector<std::string>& names) {
  if (names.empty()) return plots;
  std::vector<NamedPlot> chosen;
  for (const std::string& name : names) {
    const std::size_t before = chosen.size();
    for (const NamedPlot& plot : plots) {
      if (plot.name == name || plot.observable == name) chosen.push_back(plot);
    }
    if (chosen.size() > before) continue;
    std::vector<std::string> known;
    for (const NamedPlot& plot : plots) known.push_back(plot.name);
    throw Error(fmt::format("there is no plot '{}'; there is {}", name, fmt::join(known, ", ")));
  }
  return chosen;
}

std::vector<NamedPlot> plots_in(const std::string& directory) {
  std::error_code ignored;
  if (!fs::is_directory(directory, ignored)) throw Error("is not the directory of a run or a sweep", {directory});
  const bool sweep = is_sweep(directory);
  std::vector<NamedPlot> plots = sweep ? plots_of_sweep(directory) : plots_of_run(directory);
  if (!plots.empty()) return plots;
  const bool run = fs::exists(fs::path(directory) / "report.json", ignored);
  throw Error(sweep ? "no job of this sweep is finished yet"
              : run ? "this run observed nothing that could be plotted: see 'carom run --help' for --observe"
                    : "holds neither a run nor a sweep",
              {directory});
}

int plot_command(const PlotOptions& options) {
  std::vector<std::string> formats;
  for (const std::string& format : options.formats.empty() ? kUsualFormats : options.formats) {
    if (!kFormats.contains(format)) refuse_choice("--format", format, names_of(kFormats));
    if (std::find(formats.begin(), formats.end(), format) == formats.end()) formats.push_back(format);
  }
  const std::vector<NamedPlot> plots = named(plots_in(options.directory), options.names);
  const std::string out = out_or_plots(options.directory, options.out);
  const std::vector<std::string> written = write_plots(plots, out, formats);
  if (options.json) {
    const nlohmann::ordered_json json{{"plots", written}};
    print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
  } else {
    for (const std::string& path : written) print(path + '\n');
  }
  return kSuccess;
}

}  // namespace

std::vector<std::string> draw_sweep(const std::string& directory) {
  return write_plots(plots_of_sweep(directory), out_or_plots(directory, ""), kUsualFormats);
}

void add_plot(CLI::App& app, Action& action) {
  CLI::App* command = add_command(app, "plot", "Plots of what a run or a sweep found",
                                  "carom run scenes/gas.toml --observe speeds --out observed\n  carom plot observed");
  const auto options = std::make_shared<PlotOptions>();
  command->add_option("DIR", options->directory, "directory of a run or a sweep")->required()->type_name("");
  command->add_option("NAME", options->names, "only these plots, or those of these observables")->type_name("");
  add_path(*command, "-o,--output", options->out, "DIR", "where to put them (DIR/plots)");
  command->add_option("--format", options->formats, "svg, png or pdf; several with commas (svg,png)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->type_name("NAME");
  command->add_flag("--json", options->json, "print the names of the files as one JSON object");
  command->callback([options, &action] { action = [options] { return plot_command(*options); }; });
}
#else
std::vector<std::string> draw_sweep(const std::string& /*directory*/) { return {}; }
void add_plot(CLI::App& /*app*/, Action& /*action*/) {}  // built without pictures: there is no such command
#endif

}  // namespace carom::program
