#include "progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace carom::program {
namespace {

int terminal_columns() {
  winsize size{};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

std::string time_left(double seconds) {
  if (seconds < 60) return fmt::format("{:.0f} s left", seconds);
  if (seconds < 3600) return fmt::format("{:.0f} min left", seconds / 60);
  if (seconds < 48 * 3600) return fmt::format("{:.1f} h left", seconds / 3600);
  return fmt::format("{:.0f} days left", seconds / 86400);
}

std::string with_si_prefix(double value) {
  if (value < 1e3) return fmt::format("{:.0f} ", value);
  if (value < 1e6) return fmt::format("{:.1f} k", value / 1e3);
  return fmt::format("{:.2f} M", value / 1e6);
}

}  // namespace

std::string progress_line(const Progress& progress, double seconds, int columns) {
  const double done = std::clamp(progress.done, 0.0, 1.0);
  std::string facts = fmt::format(" {:3.0f} %", 100 * done);
  const auto add = [&](const std::string& fact, int least_bar) {
    if (static_cast<int>(facts.size() + fact.size()) + 3 + least_bar <= columns) facts += "  " + fact;
  };
  const double rate = seconds > 0 ? static_cast<double>(progress.collisions) / seconds : 0;
  if (done > 0 && seconds > 0.5) add(time_left(seconds * (1 - done) / done), 0);
  add(progress.place.empty() ? fmt::format("t = {:.6g}", progress.time) : progress.place, 10);
  add(with_si_prefix(rate) + "collisions/s", 10);

  const int room = columns - static_cast<int>(facts.size()) - 3;
  if (room < 5) return facts.substr(0, static_cast<std::size_t>(std::max(0, columns - 1)));
  const int width = std::min(room, 40);
  const int filled = static_cast<int>(done * width);
  return fmt::format("[{}{}]{}", std::string(static_cast<std::size_t>(filled), '='),
                     std::string(static_cast<std::size_t>(width - filled), ' '), facts);
}

ProgressBar::ProgressBar(bool wanted) : visible_(wanted && isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() { clear(); }

void ProgressBar::clear() {
  if (drawn_) std::fputs("\r\033[K", stderr);
  drawn_ = false;
}

void ProgressBar::show(const Progress& progress) {
  if (!visible_) return;
  const Clock::time_point now = Clock::now();
  if (now - last_drawn_ < std::chrono::milliseconds(100)) return;
  last_drawn_ = now;
  drawn_ = true;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const std::string line = fmt::format("\r{}\033[K", progress_line(progress, seconds, terminal_columns()));
  std::fputs(line.c_str(), stderr);  // a terminal that is gone is no reason to end the run
  std::fflush(stderr);
}

}  // namespace carom::program
