#pragma once
/// \file
/// Numbers in sentences for people.

#include <cstdio>
#include <string>

namespace pilotage {

/// As printf does.
template <typename... Values>
[[nodiscard]] std::string words(const char* format, Values... values) {
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    return text;
}

}  // namespace pilotage
