// What the commands of the program share: how they are added, how they fail, how they print.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <string_view>

#include "carom/state/scene.hpp"

namespace carom::program {

/// Exit codes of the program.
enum Exit : int {
  kSuccess = 0,
  kFailure = 1,       ///< bad input, a failing file, a certificate that does not hold
  kUsage = 2,         ///< options that make no sense
  kInterrupted = 130  ///< stopped by a signal, results saved
};

/// Options that contradict each other or lack something: one line on stderr, exit code 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A signal stopped a command that has nothing to save: exit code 130, no message.
class Interrupted : public std::exception {};

/// What the chosen command does, set while the command line is parsed; returns the exit code.
using Action = std::function<int()>;

/// Each adds one command (or several) to the program; the chosen one sets `action`.
void add_collide(CLI::App& app, Action& action);
void add_make(CLI::App& app, Action& action);
void add_run(CLI::App& app, Action& action);
void add_resume(CLI::App& app, Action& action);
void add_check(CLI::App& app, Action& action);
void add_info(CLI::App& app, Action& action);
void add_convert(CLI::App& app, Action& action);
void add_analyze(CLI::App& app, Action& action);
void add_draw(CLI::App& app, Action& action);
void add_plot(CLI::App& app, Action& action);
void add_sweep(CLI::App& app, Action& action);
void add_bench(CLI::App& app, Action& action);
void add_lab(CLI::App& app, Action& action);

/// A command with a description and an example shown below its help.
CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& description,
                      const std::string& example);

/// Writes to stdout. Throws Error if it cannot (a full disk behind a redirection); where the reader of a pipe has
/// gone, ends the program by SIGPIPE as other programs do.
void print(std::string_view text);

/// Writes the line "carom: MESSAGE" to stderr. Where that fails there is nobody left to tell.
void tell(const std::string& message);

/// realize(), but every problem names the scene's file.
Setup realize_here(const Scene& scene);

/// The words the program was called with, as one line.
std::string command_line();
void remember_command_line(int count, char** words);

}  // namespace carom::program
