// Loaded before the C library (LD_PRELOAD): lets the n-th request for memory fail, counted from when main() begins.
//
//   MEMORY_FAIL_AT  number of the request that fails, counted from 1; 0: none, they are only counted
//   MEMORY_LEAST    only requests of so many bytes or more count and fail; 1 by default
//   MEMORY_REST     if set, all later ones of that size fail, too: memory stays short
//   MEMORY_SPARE    requests made by a library of this name neither count nor fail
//   COUNT_TO        a file that gets the number of requests at the process's end
#include <dlfcn.h>

#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* old, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace {

std::atomic<long> requests{0};
bool main_has_begun = false;
int (*main_of_the_program)(int, char**, char**) = nullptr;

int begin(int count, char** words, char** variables) {
  main_has_begun = true;
  return main_of_the_program(count, words, variables);
}

long number_of(const char* name) {
  const char* const text = std::getenv(name);
  return text != nullptr ? std::strtol(text, nullptr, 10) : 0;
}

/// Whether the code at this address is of the library to be spared.
bool is_spared(const void* caller) {
  static const char* const name = std::getenv("MEMORY_SPARE");
  Dl_info about{};
  return name != nullptr && dladdr(caller, &about) != 0 && std::strstr(about.dli_fname, name) != nullptr;
}

bool fails(std::size_t size, const void* caller) {
  static const long at = number_of("MEMORY_FAIL_AT");
  static const long least = number_of("MEMORY_LEAST");
  static const bool rest = std::getenv("MEMORY_REST") != nullptr;
  if (!main_has_begun || static_cast<long>(size) < least || is_spared(caller)) return false;
  const long now = ++requests;
  if (at == 0 || (now != at && !(rest && now > at))) return false;
  errno = ENOMEM;
  return true;
}

struct Teller {
  ~Teller() {
    const char* const path = std::getenv("COUNT_TO");
    const long count = requests.load();
    std::FILE* const file = path != nullptr ? std::fopen(path, "w") : nullptr;
    if (file == nullptr) return;
    std::fprintf(file, "%ld\n", count);
    std::fclose(file);
  }
} teller;

}  // namespace

extern "C" {

int __libc_start_main(int (*main)(int, char**, char**), int count, char** words, int (*init)(int, char**, char**),
                      void (*fini)(), void (*loader_fini)(), void* stack_end) {
  main_of_the_program = main;
  const auto real = reinterpret_cast<decltype(&__libc_start_main)>(dlsym(RTLD_NEXT, "__libc_start_main"));
  return real(begin, count, words, init, fini, loader_fini, stack_end);
}

void* malloc(std::size_t size) { return fails(size, __builtin_return_address(0)) ? nullptr : __libc_malloc(size); }

void* calloc(std::size_t count, std::size_t size) {
  return fails(count * size, __builtin_return_address(0)) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* old, std::size_t size) {
  return fails(size, __builtin_return_address(0)) ? nullptr : __libc_realloc(old, size);
}

char* strdup(const char* text) noexcept {
  const std::size_t size = std::strlen(text) + 1;
  void* const copy = fails(size, __builtin_return_address(0)) ? nullptr : __libc_malloc(size);
  return copy == nullptr ? nullptr : static_cast<char*>(std::memcpy(copy, text, size));
}

void* memalign(std::size_t alignment, std::size_t size) {
  return fails(size, __builtin_return_address(0)) ? nullptr : __libc_memalign(alignment, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) { return memalign(alignment, size); }

int posix_memalign(void** found, std::size_t alignment, std::size_t size) {
  void* const memory = memalign(alignment, size);
  if (memory == nullptr) return ENOMEM;
  *found = memory;
  return 0;
}

}  // extern "C"
