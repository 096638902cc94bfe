#include "text_table.hpp"

#include <cerrno>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

namespace pilotage {

namespace {

constexpr std::size_t kFlushAt = std::size_t{1} << 16;

[[noreturn]] void fail(const std::string& path, const char* what) {
    throw std::runtime_error(path + ": cannot be " + what + ": " + std::strerror(errno));
}

bool separates(char c) noexcept {
    return c == ' ' || c == '\t' || c == ',' || c == '\r';
}

std::string read_all(const std::string& path) {
    const std::unique_ptr<std::FILE, decltype(&std::fclose)> file(std::fopen(path.c_str(), "rb"),
                                                                  &std::fclose);
    if (!file) fail(path, "opened");
    std::string text;
    char block[1 << 16];
    while (const std::size_t n = std::fread(block, 1, sizeof block, file.get()))
        text.append(block, n);
    if (std::ferror(file.get())) fail(path, "read");
    return text;
}

}  // namespace

TextTable::TextTable(const std::string& path) : path_(path), file_(std::fopen(path.c_str(), "wb")) {
    if (!file_) fail(path_, "opened for writing");
}

void TextTable::put(const char* text, std::size_t size, char before) {
    if (before != 0) buffer_ += before;
    buffer_.append(text, size);
}

void TextTable::number(double v, char before) {
    char text[32];
    put(text, static_cast<std::size_t>(std::to_chars(text, text + sizeof text, v).ptr - text),
        before);
}

void TextTable::integer(std::int64_t v, char before) {
    char text[24];
    put(text, static_cast<std::size_t>(std::to_chars(text, text + sizeof text, v).ptr - text),
        before);
}

void TextTable::word(std::string_view v, char before) {
    put(v.data(), v.size(), before);
}

void TextTable::seconds(std::int64_t utime, char before) {
    char text[40];
    const int size = std::snprintf(text, sizeof text, "%s%lld.%06lld", utime < 0 ? "-" : "",
                                   std::llabs(utime / 1'000'000), std::llabs(utime % 1'000'000));
    put(text, static_cast<std::size_t>(size), before);
}

void TextTable::line(std::string_view v) {
    buffer_ += v;
    buffer_ += '\n';
    if (buffer_.size() < kFlushAt) return;
    if (std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) != buffer_.size())
        fail(path_, "written");
    buffer_.clear();
}

void TextTable::close() {
    const bool whole =
        std::fwrite(buffer_.data(), 1, buffer_.size(), file_.get()) == buffer_.size();
    if (!whole || std::fclose(file_.release()) != 0) fail(path_, "written");
}

std::vector<double> read_table(const std::string& path, const std::vector<int>& columns) {
    const std::string text = read_all(path);
    std::vector<double> rows, fields;
    std::size_t line_number = 0, width = 0;
    const auto complain = [&](const std::string& what) {
        throw std::invalid_argument(path + ":" + std::to_string(line_number) + ": " + what);
    };
    for (std::size_t begin = 0; begin < text.size();) {
        std::size_t end = text.find('\n', begin);
        if (end == std::string::npos) end = text.size();
        const char* at = text.data() + begin;
        const char* const stop = text.data() + end;
        begin = end + 1;
        ++line_number;
        fields.clear();
        while (true) {
            while (at != stop && separates(*at)) ++at;
            if (at == stop || *at == '#' || *at == '%') break;
            double value = 0;
            const bool plus = *at == '+' && stop - at > 1 && at[1] != '-';
            const auto [next, error] = std::from_chars(at + (plus ? 1 : 0), stop, value);
            if (error != std::errc{} || (next != stop && !separates(*next))) {
                const char* word = at;
                while (word != stop && !separates(*word)) ++word;
                complain("'" + std::string(at, word) + "' is not a number");
            }
            fields.push_back(value);
            at = next;
        }
        if (fields.empty()) continue;
        if (width == 0) width = fields.size();
        if (fields.size() != width)
            complain("has " + std::to_string(fields.size()) + " columns, the rows before it have " +
                     std::to_string(width));
        for (const int column : columns) {
            if (column < 0 || static_cast<std::size_t>(column) >= width)
                complain("has " + std::to_string(width) + " columns, column " +
                         std::to_string(column + 1) + " is needed");
            rows.push_back(fields[static_cast<std::size_t>(column)]);
        }
    }
    return rows;
}

}  // namespace pilotage
