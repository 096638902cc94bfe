#pragma once
/// \file
/// How much was fuzzed, said at the end of the program.

#include <chrono>
#include <cstdio>

namespace pilotage::test {

class Progress {
   public:
    explicit Progress(const char* what) : what_(what) {}
    ~Progress() {
        const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
        std::fprintf(stderr, "%lld %s in %.0f s, %.0f a second\n", count_, what_, spent.count(),
                     static_cast<double>(count_) / spent.count());
    }
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void add() noexcept { ++count_; }

   private:
    const char* what_;
    long long count_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace pilotage::test
