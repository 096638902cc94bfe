#pragma once
/// \file
/// Tables of numbers as text, written and read fast: std::to_chars and std::from_chars give the
/// shortest text that reads back as the same number, whatever the locale.

#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace pilotage {

/// Writes a table. \throws std::runtime_error naming the file
class TextTable {
   public:
    explicit TextTable(const std::string& path);

    void number(double v, char before = 0);
    void integer(std::int64_t v, char before = 0);
    void word(std::string_view v, char before = 0);
    /// A time [us] as seconds with six decimals.
    void seconds(std::int64_t utime, char before = 0);
    /// Ends the row.
    void line(std::string_view v);
    void close();

   private:
    void put(const char* text, std::size_t size, char before);
    struct Close {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };
    std::string path_;
    std::unique_ptr<std::FILE, Close> file_;
    std::string buffer_;
};

/// Columns of a table of numbers separated by blanks, tabs or commas; lines that are empty or begin
/// with # or % are passed over. Columns count from 0.
/// \return row-major, columns.size() numbers a row
/// \throws std::invalid_argument naming file and line where a row is ragged or a field is no
/// number, std::runtime_error if the file cannot be read
[[nodiscard]] std::vector<double> read_table(const std::string& path,
                                             const std::vector<int>& columns);

}  // namespace pilotage
