// Tables of numbers as text: what is written reads back as the same number, what is broken is
// named.

#include "engine/text_table.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/files.hpp"
#include "support/random.hpp"

namespace pilotage::test {
namespace {

std::vector<double> columns_of(const std::string& text, const std::vector<int>& columns) {
    const Folder folder;
    return read_table(folder.write("table.txt", text), columns);
}

/// What reading complains about, without the folder.
std::string table_error(const std::string& text, const std::vector<int>& columns = {0}) {
    const Folder folder;
    const std::string path = folder.write("table.txt", text);
    const std::string error =
        complaint<std::invalid_argument>([&] { (void)read_table(path, columns); });
    return error.find(path) == 0 ? "table.txt" + error.substr(path.size()) : error;
}

TEST(ReadTableTest, TakesTheColumnsThatAreAskedForInTheirOrder) {
    EXPECT_EQ(columns_of("1 2 3\n4 5 6\n", {2, 0}), (std::vector<double>{3, 1, 6, 4}));
    EXPECT_EQ(columns_of("1 2 3\n4 5 6\n", {1, 1}), (std::vector<double>{2, 2, 5, 5}));
}

TEST(ReadTableTest, TakesBlanksTabsCommasAndLineEndsOfEveryKind) {
    EXPECT_EQ(columns_of("  1\t2,3  \r\n\r\n4, 5 ,6", {0, 1, 2}),
              (std::vector<double>{1, 2, 3, 4, 5, 6}));
}

TEST(ReadTableTest, PassesOverCommentsAndEmptyLines) {
    EXPECT_EQ(columns_of("# x y\n% Matlab's\n\n   \n1 2 # here\n3 4 % and here\n", {0, 1}),
              (std::vector<double>{1, 2, 3, 4}));
    EXPECT_TRUE(columns_of("", {0}).empty());
    EXPECT_TRUE(columns_of("# nothing\n", {0}).empty());
}

TEST(ReadTableTest, ReadsNumbersAsTheyAreWritten) {
    EXPECT_EQ(columns_of("-1.5 +2 1e3 1E-2 .5 -0 1e+2\n", {0, 1, 2, 3, 4, 6}),
              (std::vector<double>{-1.5, 2, 1000, 0.01, 0.5, 100}));
    EXPECT_TRUE(std::isnan(columns_of("nan\n", {0})[0]));
    EXPECT_EQ(columns_of("-inf\n", {0})[0], -std::numeric_limits<double>::infinity());
}

TEST(ReadTableTest, NamesFileAndLineOfARaggedRow) {
    EXPECT_EQ(table_error("# head\n1 2 3\n\n4 5\n"),
              "table.txt:4: has 2 columns, the rows before it have 3");
    EXPECT_EQ(table_error("1 2\n3 4 5\n"), "table.txt:2: has 3 columns, the rows before it have 2");
}

TEST(ReadTableTest, NamesWhatIsNoNumber) {
    EXPECT_EQ(table_error("1 2\n3 four 5\n"), "table.txt:2: 'four' is not a number");
    EXPECT_EQ(table_error("1 2\n3 4x\n"), "table.txt:2: '4x' is not a number");
    EXPECT_EQ(table_error("1;2\n"), "table.txt:1: '1;2' is not a number");
    EXPECT_EQ(table_error("1e999\n"), "table.txt:1: '1e999' is not a number");
    for (const char* bad : {"+", "+-1", "-", "0x10", "1,5e", "--1", "1.2.3"})
        EXPECT_NE(table_error(std::string(bad) + "\n").find("table.txt:1: '"), std::string::npos)
            << bad;
    EXPECT_NE(table_error(std::string("1 \0 2\n", 6)), "") << "a binary file";
}

TEST(ReadTableTest, NamesAColumnThatIsNotThere) {
    EXPECT_EQ(table_error("\n1 2 3\n", {0, 3}), "table.txt:2: has 3 columns, column 4 is needed");
    EXPECT_EQ(table_error("1 2 3\n", {-1}), "table.txt:1: has 3 columns, column 0 is needed");
}

TEST(ReadTableTest, NamesAFileThatCannotBeRead) {
    const Folder folder;
    const auto error = [&](const std::string& name) {
        return complaint<std::runtime_error>([&] { (void)read_table(folder.path(name), {0}); });
    };
    EXPECT_EQ(error("none.txt"),
              folder.path("none.txt") + ": cannot be opened: No such file or directory");
    EXPECT_NE(error("").find("cannot be"), std::string::npos) << "a folder";
}

TEST(TextTableTest, WritesNumbersThatReadBackAsTheSame) {
    const Folder folder;
    Draw draw(9);
    std::vector<double> numbers = {
        0.1, 1.0 / 3, -0.0, 5e-324, 1.7976931348623157e308, 1e-17, 123456789012345680.0};
    for (int i = 0; i < 2000; ++i)
        numbers.push_back(draw.uniform(-1, 1) * draw.log_uniform(1e-300, 1e300));
    TextTable table(folder.path("table.txt"));
    for (const double v : numbers) {
        table.number(v);
        table.number(-v, ' ');
        table.line("");
    }
    table.close();
    const std::vector<double> back = read_table(folder.path("table.txt"), {0, 1});
    ASSERT_EQ(back.size(), 2 * numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        ASSERT_EQ(back[2 * i], numbers[i]);
        ASSERT_EQ(back[2 * i + 1], -numbers[i]);
    }
}

TEST(TextTableTest, WritesRows) {
    const Folder folder;
    TextTable table(folder.path("table.csv"));
    table.line("id,name,value");
    table.integer(-9223372036854775807 - 1);
    table.word("camera", ',');
    table.number(0.5, ',');
    table.line("");
    table.integer(0);
    table.word("", ',');
    table.number(std::numeric_limits<double>::quiet_NaN(), ',');
    table.line("");
    table.close();
    EXPECT_EQ(folder.read("table.csv"), "id,name,value\n-9223372036854775808,camera,0.5\n0,,nan\n");
}

TEST(TextTableTest, WritesTimesAsSecondsWithSixDecimals) {
    const Folder folder;
    TextTable table(folder.path("table.txt"));
    for (const std::int64_t utime :
         {std::int64_t{0}, std::int64_t{1}, std::int64_t{-1}, std::int64_t{1'500'000},
          std::int64_t{-1'500'000}, std::int64_t{-500'000}, std::int64_t{1'700'000'000'123'456},
          std::numeric_limits<std::int64_t>::max(), std::numeric_limits<std::int64_t>::min()}) {
        table.seconds(utime);
        table.line("");
    }
    table.close();
    EXPECT_EQ(folder.read("table.txt"),
              "0.000000\n0.000001\n-0.000001\n1.500000\n-1.500000\n-0.500000\n1700000000.123456\n"
              "9223372036854.775807\n-9223372036854.775808\n");
}

TEST(TextTableTest, NamesAFileThatCannotBeWritten) {
    const Folder folder;
    EXPECT_EQ(
        complaint<std::runtime_error>([&] { TextTable(folder.path("no/such.csv")); }),
        folder.path("no/such.csv") + ": cannot be opened for writing: No such file or directory");
    if (!std::filesystem::exists("/dev/full")) return;
    const auto fill = [] {
        TextTable table("/dev/full");
        for (int i = 0; i < 100'000; ++i) table.line("a line of some length");
        table.close();
    };
    EXPECT_EQ(complaint<std::runtime_error>(fill),
              "/dev/full: cannot be written: No space left on device");
    EXPECT_EQ(complaint<std::runtime_error>([] { TextTable("/dev/full").close(); }), "")
        << "nothing to write";
}

}  // namespace
}  // namespace pilotage::test
