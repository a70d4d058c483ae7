#include "command.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <sstream>

#include "carom/base/error.hpp"

namespace carom::program {
namespace {

std::string the_command_line;  // written once, by main

std::string quoted_if_needed(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_of(" \t\n'\"\\$`*?[]{}()<>|&;~#!") == std::string::npos;
  return plain ? word : '\'' + word + '\'';
}

}  // namespace

CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& description,
                      const std::string& example) {
  CLI::App* command = app.add_subcommand(name, description);
  command->footer("\nExample:\n  " + example);
  return command;
}

std::vector<double> parse_numbers(std::string_view option, const std::string& text) {
  std::vector<double> numbers;
  std::istringstream words(text);
  for (std::string word; std::getline(words, word, ',');) {
    double value = 0;
    if (!CLI::detail::lexical_cast(word, value) || !std::isfinite(value)) {
      throw UsageError(fmt::format("{} {}: '{}' is not a finite number", option, text, word));
    }
    numbers.push_back(value);
  }
  if (!text.empty() && text.back() == ',')
    throw UsageError(fmt::format("{} {}: a number is missing at the end", option, text));
  return numbers;
}

void print(std::string_view text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (!written) throw Error(fmt::format("cannot write to standard output: {}", std::strerror(errno)));
}

std::string command_line() { return the_command_line; }

void remember_command_line(int count, char** words) {
  the_command_line = "carom";
  for (int k = 1; k < count; ++k) the_command_line += ' ' + quoted_if_needed(words[k]);
}

}  // namespace carom::program
