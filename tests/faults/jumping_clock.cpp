// Loaded before the C library (LD_PRELOAD): every question for the date is answered with another one, CLOCK_JUMP
// seconds (a year, say) later or earlier than the one before, as if somebody set the system's clock back and forth.
// Clocks that cannot be set tell the truth.
#include <dlfcn.h>
#include <sys/time.h>
#include <time.h>

#include <cstdlib>
#include <ctime>

namespace {

/// Ahead at first, and at every other question after that.
long jump() {
  static const char* const text = std::getenv("CLOCK_JUMP");
  static const long seconds = text != nullptr ? std::strtol(text, nullptr, 10) : 0;
  static long asked = 0;
  return ++asked % 2 == 1 ? seconds : 0;
}

int ask(clockid_t clock, timespec* now) {
  using Asking = int(clockid_t, timespec*);
  static const auto real = reinterpret_cast<Asking*>(dlsym(RTLD_NEXT, "clock_gettime"));
  return real(clock, now);
}

timespec date() {
  timespec now{};
  ask(CLOCK_REALTIME, &now);
  now.tv_sec += jump();
  return now;
}

}  // namespace

extern "C" {

int clock_gettime(clockid_t clock, timespec* now) noexcept {
  if (clock != CLOCK_REALTIME && clock != CLOCK_REALTIME_COARSE) return ask(clock, now);
  *now = date();
  return 0;
}

int gettimeofday(timeval* now, void*) noexcept {
  const timespec found = date();
  *now = {found.tv_sec, found.tv_nsec / 1000};
  return 0;
}

time_t time(time_t* into) noexcept {
  const time_t now = date().tv_sec;
  if (into != nullptr) *into = now;
  return now;
}

}  // extern "C"
