// The program `carom`: parses the command line, runs one command, turns errors into a line and an exit code.
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <sstream>

#include "carom/carom.hpp"
#include "command.hpp"

namespace carom::program {
namespace {

std::string version_line() {
  return fmt::format("carom {} (SIMD {}; {})", version(), name_of(fastest_simd()), compiler());
}

/// --version, for the program and each of its commands.
void add_version_flag(CLI::App& app) {
  app.set_version_flag("--version", version_line());
  for (CLI::App* command : app.get_subcommands({})) add_version_flag(*command);
}

/// The command whose options were being read, as typed: "carom make gas".
std::string chosen_command(const CLI::App& app) {
  std::string words = app.get_name();
  for (const CLI::App* command : app.get_subcommands()) words += ' ' + chosen_command(*command);
  return words;
}

int fail_usage(const CLI::App& app, const std::string& message) {
  tell(fmt::format("{} ('{} --help' tells what can be given)", message, chosen_command(app)));
  return kUsage;
}

/// What CLI11 has to say about a command line, in plainer words where a newcomer is likely to need them.
std::string describe(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> rest = app.remaining(true);
  for (const std::string& word : rest) {
    if (word.starts_with('-')) return fmt::format("there is no option '{}'", word);
  }
  if (!app.get_subcommands().empty()) return error.what();
  return rest.empty() ? "which command?" : fmt::format("there is no command '{}'", rest.front());
}

/// Help and version go to stdout with code 0, anything else that CLI11 finds is a usage error.
int answer(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() != 0) return fail_usage(app, describe(app, error));
  std::ostringstream text;
  app.exit(error, text, text);
  print(text.str());
  return kSuccess;
}

void add_commands(CLI::App& app, Action& action) {
  add_collide(app, action);
  add_make(app, action);
  add_run(app, action);
  add_resume(app, action);
  add_check(app, action);
  add_info(app, action);
  add_convert(app, action);
  add_analyze(app, action);
  add_draw(app, action);
  add_plot(app, action);
  add_sweep(app, action);
  add_bench(app, action);
#ifdef CAROM_HAS_LAB
  add_lab(app, action);
#endif
  add_version_flag(app);
}

int parse_and_act(int count, char** words) {
  CLI::App app("carom: exact, reproducible collisions of disks in two dimensions", "carom");
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::simple);
  app.footer(
      "\nExample:\n  carom collide --disk 0,0,1,0 --disk 0.6,0.8,0,0 --explain\n\n'carom COMMAND --help' tells more.");
  Action action;
  add_commands(app, action);
  try {
    app.parse(count, words);
    return action();
  } catch (const CLI::ParseError& error) {
    return answer(app, error);
  } catch (const UsageError& error) {
    return fail_usage(app, error.what());
  }
}

int run_program(int count, char** words) {
  try {
    remember_command_line(count, words);
    return parse_and_act(count, words);
  } catch (const Interrupted&) {
    return kInterrupted;
  } catch (const Error& error) {
    for (const Problem& problem : error.problems()) tell(to_string(problem));
  } catch (const std::bad_alloc&) {
    tell("out of memory in: " + command_line());
  } catch (const std::exception& error) {
    tell(fmt::format("this should not happen, please report it: {}", error.what()));
  }
  return kFailure;
}

/// Destructors may need memory: those of JSON values do. An exception that leaves one ends up here.
[[noreturn]] void on_termination() {
  if (const std::exception_ptr failure = std::current_exception()) {
    try {
      std::rethrow_exception(failure);
    } catch (const std::bad_alloc&) {
      std::fputs("carom: out of memory\n", stderr);
      _exit(kFailure);
    } catch (...) {
      // A fault of ours.
    }
  }
  std::abort();
}

}  // namespace

/// Where the caller closed stdin, stdout or stderr, puts something in its place that can be neither read nor written;
/// else the next file opened would get its number, and our messages.
void occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) < 0) open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
  }
}

}  // namespace carom::program

int main(int count, char** words) {
  carom::program::occupy_standard_streams();
  // A file at its size limit and a pipe that nobody reads are errors like any other.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  std::set_terminate(carom::program::on_termination);
  return carom::program::run_program(count, words);
}
