#pragma once
/// \file
/// A checkpoint as bytes, and its file: a checkpoint_t and its CRC-32. A file is either whole or
/// the one before, whatever happens while it is written.

#include <cstdint>
#include <string>
#include <vector>

#include "pilotage/checkpoint.hpp"
#include "pilotage/checkpoint_t.hpp"

namespace pilotage {

using Bytes = std::vector<std::uint8_t>;

/// FNV-1a, to tell one text from another.
[[nodiscard]] std::int64_t hash_of(const std::string& text) noexcept;

void fill(checkpoint_t& message, const Checkpoint& checkpoint);
/// \throws std::runtime_error if the message has another number of states
[[nodiscard]] Checkpoint checkpoint_of(const checkpoint_t& message);

[[nodiscard]] Bytes pack(const checkpoint_t& message);
/// \throws std::runtime_error saying what is wrong with the bytes
[[nodiscard]] checkpoint_t unpack(const Bytes& bytes);

/// Empty if there is no such file. \throws std::runtime_error saying what is wrong with the file
[[nodiscard]] Bytes read_bytes(const std::string& path);
/// Writes beside `path` and renames. \throws std::runtime_error
void replace_file(const std::string& path, const Bytes& bytes);

}  // namespace pilotage
