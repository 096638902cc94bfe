#pragma once
/// \file
/// Whether a sanitizer looks on, which gcc and clang say in different ways.

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PILOTAGE_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PILOTAGE_SANITIZED
#endif
#endif

namespace pilotage::test {

/// How often to do what a plain build does `times` times. Under a sanitizer it is a fifth: that
/// looks at memory and threads, of which the first few runs show all, and takes five times as long.
/// The statistics of many runs are the plain build's.
[[nodiscard]] constexpr int repeats(int times) {
#ifdef PILOTAGE_SANITIZED
    return times < 5 ? 1 : times / 5;
#else
    return times;
#endif
}

}  // namespace pilotage::test
