// Memory for large arrays that are read at random: in huge pages where the system has them.
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace carom::fast {

template <class T>
struct HugePages {
  using value_type = T;
  static constexpr std::size_t kPage = std::size_t{1} << 21;

  HugePages() noexcept = default;
  template <class Other>
  HugePages(const HugePages<Other>&) noexcept {}  // NOLINT(google-explicit-constructor): allocators convert

  [[nodiscard]] static constexpr std::size_t alignment(std::size_t count) noexcept {
    return count * sizeof(T) >= kPage ? kPage : alignof(T) > 64 ? alignof(T) : 64;
  }

  T* allocate(std::size_t count) {
    const std::size_t align = alignment(count);
    void* memory = ::operator new (count * sizeof(T), std::align_val_t{align});
#ifdef __linux__
    if (align == kPage) madvise(memory, count * sizeof(T), MADV_HUGEPAGE);  // a hint: it may fail
#endif
    return static_cast<T*>(memory);
  }

  void deallocate(T* memory, std::size_t count) noexcept {
    ::operator delete (memory, std::align_val_t{alignment(count)});
  }

  template <class Other>
  friend bool operator==(const HugePages&, const HugePages<Other>&) noexcept {
    return true;
  }
};

template <class T>
using Array = std::vector<T, HugePages<T>>;

}  // namespace carom::fast
