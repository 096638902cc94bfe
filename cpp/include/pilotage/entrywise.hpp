#pragma once
/// \file
/// Small matrices by their entries, as equations with indices read. For two to six rows this beats
/// expressions of whole matrices: every index is a constant, everything stays in registers, and no
/// vector load has to wait for the scalar stores before it. Functions of the hot path that use it
/// are marked `flatten`, so that what is written as a lambda costs no call.

#include <utility>

namespace pilotage {

/// Whether the compiler sees that a is zero.
template <typename Scalar>
[[nodiscard, gnu::always_inline]] inline bool known_zero(Scalar a) noexcept {
    return __builtin_constant_p(a) && a == 0;
}

/// a b. A product that is known to be zero is -0, which adds for nothing: a Jacobian's zeros are
/// free.
template <typename Scalar>
[[nodiscard, gnu::always_inline]] inline Scalar times(Scalar a, Scalar b) noexcept {
    return known_zero(a) || known_zero(b) ? Scalar(-0.0) : a * b;
}

namespace detail {

template <typename Body, int... I>
[[gnu::always_inline]] inline void each(const Body& body,
                                        std::integer_sequence<int, I...>) noexcept {
    (body(I), ...);
}

template <typename A, typename B, int... K>
[[gnu::always_inline]] inline auto row_by_row(const A& a, int i, const B& b, int j,
                                              std::integer_sequence<int, K...>) noexcept {
    return (times(a(i, K), b(j, K)) + ...);
}

template <typename A, typename B, int... K>
[[gnu::always_inline]] inline auto row_by_column(const A& a, int i, const B& b, int j,
                                                 std::integer_sequence<int, K...>) noexcept {
    return (times(a(i, K), b(K, j)) + ...);
}

template <typename M, typename Entry, int... I>
[[gnu::always_inline]] inline void fill(M& m, const Entry& entry,
                                        std::integer_sequence<int, I...>) noexcept {
    constexpr int kRows = M::RowsAtCompileTime;
    ((m(I % kRows, I / kRows) = entry(I % kRows, I / kRows)), ...);
}

template <typename M, typename Entry, int... I>
[[gnu::always_inline]] inline void fill_lower(M& m, const Entry& entry,
                                              std::integer_sequence<int, I...>) noexcept {
    constexpr int kRows = M::RowsAtCompileTime;
    ((I % kRows >= I / kRows ? void(m(I % kRows, I / kRows) = entry(I % kRows, I / kRows))
                             : void()),
     ...);
}

}  // namespace detail

/// body(0), ..., body(Count - 1)
template <int Count, typename Body>
[[gnu::always_inline]] inline void each(const Body& body) noexcept {
    detail::each(body, std::make_integer_sequence<int, Count>{});
}

/// Row i of A times row j of B, (A B')_ij, over the columns of B.
template <typename A, typename B>
[[nodiscard, gnu::always_inline]] inline auto row_by_row(const A& a, int i, const B& b,
                                                         int j) noexcept {
    return detail::row_by_row(a, i, b, j, std::make_integer_sequence<int, B::ColsAtCompileTime>{});
}

/// Row i of A times column j of B, (A B)_ij, over the columns of A.
template <typename A, typename B>
[[nodiscard, gnu::always_inline]] inline auto row_by_column(const A& a, int i, const B& b,
                                                            int j) noexcept {
    return detail::row_by_column(a, i, b, j,
                                 std::make_integer_sequence<int, A::ColsAtCompileTime>{});
}

/// m(i, j) = entry(i, j)
template <typename M, typename Entry>
[[gnu::always_inline]] inline void fill(M& m, const Entry& entry) noexcept {
    detail::fill(m, entry, std::make_integer_sequence<int, M::SizeAtCompileTime>{});
}

/// m(i, j) = entry(i, j) for i >= j
template <typename M, typename Entry>
[[gnu::always_inline]] inline void fill_lower(M& m, const Entry& entry) noexcept {
    detail::fill_lower(m, entry, std::make_integer_sequence<int, M::SizeAtCompileTime>{});
}

/// m(i, j) += entry(i, j) for i >= j
template <typename M, typename Entry>
[[gnu::always_inline]] inline void add_lower(M&& m, const Entry& entry) noexcept {
    fill_lower(m, [&](int i, int j) { return m(i, j) + entry(i, j); });
}

/// m(i, j) = m(j, i) = entry(i, j) for i >= j
template <typename M, typename Entry>
[[gnu::always_inline]] inline void fill_symmetric(M& m, const Entry& entry) noexcept {
    fill_lower(m, [&](int i, int j) { return m(j, i) = entry(i, j); });
}

/// The matrix of the given entries.
template <typename M, typename Entry>
[[nodiscard, gnu::always_inline]] inline M entries(const Entry& entry) noexcept {
    M m;
    fill(m, entry);
    return m;
}

/// A copy to pass on in memory, so that the original may stay in registers.
template <typename M>
[[nodiscard, gnu::always_inline]] inline M copy_of(const M& m) noexcept {
    return entries<M>([&](int i, int j) { return m(i, j); });
}

/// The symmetric matrix of the given entries, which are asked for where i >= j.
template <typename M, typename Entry>
[[nodiscard, gnu::always_inline]] inline M symmetric(const Entry& entry) noexcept {
    M m;
    fill_symmetric(m, entry);
    return m;
}

}  // namespace pilotage
