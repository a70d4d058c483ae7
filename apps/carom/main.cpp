// The program `carom`: parses the command line, runs one command, turns errors into a line and an exit code.
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <iostream>

#include "carom/carom.hpp"
#include "command.hpp"

namespace carom::program {
namespace {

std::string version_line() {
  return fmt::format("carom {} (SIMD {}; {})", version(), make_reference_solver(System{})->simd(), compiler());
}

/// Help and version go to stdout with code 0, anything else that CLI11 finds is a usage error.
int report(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error, std::cout, std::cerr);
  fmt::print(stderr, "carom: {}\n", error.what());
  fmt::print(stderr, "'carom --help' and 'carom COMMAND --help' tell what can be given.\n");
  return kUsage;
}

int run_program(int count, char** words) {
  CLI::App app("carom: exact, reproducible collisions of disks in two dimensions", "carom");
  app.set_version_flag("--version", version_line());
  app.require_subcommand(1);
  app.failure_message(CLI::FailureMessage::simple);
  app.footer(
      "\nExample:\n  carom collide --disk 0,0,1,0 --disk 0.6,0.8,0,0 --explain\n\n'carom COMMAND --help' tells more.");
  Action action;
  add_collide(app, action);
  add_make(app, action);
  add_run(app, action);
  add_check(app, action);
  add_info(app, action);
  add_convert(app, action);
  add_draw(app, action);

  try {
    app.parse(count, words);
    return action();
  } catch (const CLI::ParseError& error) {
    return report(app, error);
  } catch (const UsageError& error) {
    fmt::print(stderr, "carom: {}\n", error.what());
    return kUsage;
  } catch (const Error& error) {
    for (const Problem& problem : error.problems()) fmt::print(stderr, "carom: {}\n", to_string(problem));
    return kFailure;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "carom: out of memory\n");
    return kFailure;
  }
}

}  // namespace
}  // namespace carom::program

int main(int count, char** words) {
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its size limit is an error like any other
  carom::program::remember_command_line(count, words);
  return carom::program::run_program(count, words);
}
