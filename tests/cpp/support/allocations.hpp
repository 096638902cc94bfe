#pragma once
/// \file
/// Counts what this program takes from the heap, by `new` or by `malloc`.

namespace pilotage::test {

/// Allocations of the calling thread since it was constructed.
class AllocationCount {
   public:
    AllocationCount() noexcept : start_(total()) {}
    [[nodiscard]] long since() const noexcept { return total() - start_; }

   private:
    [[nodiscard]] static long total() noexcept;
    long start_;
};

}  // namespace pilotage::test
