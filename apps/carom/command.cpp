#include "command.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <optional>

#include "carom/base/error.hpp"

namespace carom::program {
namespace {

std::string the_command_line;  // written once, by main

std::string quoted_if_needed(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_of(" \t\n'\"\\$`*?[]{}()<>|&;~#!") == std::string::npos;
  return plain ? word : '\'' + word + '\'';
}

/// Disks that a gas will have, as far as that can be told beforehand.
double expected_disks(const GasSpec& gas, const std::optional<Vec2>& size) {
  if (gas.count) return static_cast<double>(*gas.count);
  if (!gas.packing_fraction || !size) return 0;
  return *gas.packing_fraction * size->x * size->y / (kPi * gas.radius * gas.radius);
}

}  // namespace

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& description,
                      const std::string& example) {
  CLI::App* command = app.add_subcommand(name, description);
  command->footer("\nExample:\n  " + example);
  return command;
}

void print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return;
  const int reason = errno;
  if (reason == EPIPE) {
    std::signal(SIGPIPE, SIG_DFL);
    std::raise(SIGPIPE);
  }
  throw Error(fmt::format("cannot write to standard output: {}", std::strerror(reason)));
}

void tell(const std::string& message) {
  const std::string line = fmt::format("carom: {}\n", message);
  std::fputs(line.c_str(), stderr);
}

void require_memory_for(double disks, const Place& place) {
  constexpr double kBytesPerDisk = 250;  // of a simulation with its first frame, rounded up
  const double memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
  if (!(disks * kBytesPerDisk > memory)) return;
  throw Error(fmt::format("{:.10g} disks need about {:.0f} GB of memory; this machine has {:.0f} GB", disks,
                          disks * kBytesPerDisk / 1e9, memory / 1e9),
              place);
}

Setup realize_here(const Scene& scene) {
  double disks = 0;
  for (const GasSpec& gas : scene.gas) {
    disks += expected_disks(gas, scene.size);
    require_memory_for(disks, gas.place);
  }
  try {
    return realize(scene);
  } catch (const Error& error) {
    std::vector<Problem> problems = error.problems();
    for (Problem& problem : problems) {
      if (problem.place.file.empty()) problem.place.file = scene.box_place.file;
    }
    throw Error(problems);
  }
}

std::string command_line() { return the_command_line; }

void remember_command_line(int count, char** words) {
  the_command_line = "carom";
  for (int k = 1; k < count; ++k) the_command_line += ' ' + quoted_if_needed(words[k]);
}

}  // namespace carom::program
