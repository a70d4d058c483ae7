#include "command.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>

#include "carom/base/error.hpp"

namespace carom::program {
namespace {

std::string the_command_line;  // written once, by main

std::string quoted_if_needed(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_of(" \t\n'\"\\$`*?[]{}()<>|&;~#!") == std::string::npos;
  if (plain) return word;
  std::string quoted = "'";
  for (const char letter : word) quoted += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return quoted + "'";
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

Setup realize_here(const Scene& scene) {
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
