// A checkpoint as bytes and as a file: whole, or known to be none.

#include "engine/checkpoint_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <thread>

#include "support/engines.hpp"
#include "support/files.hpp"
#include "support/journeys.hpp"

namespace pilotage::test {
namespace {

checkpoint_t message_of(int states) {
    Draw draw(5);
    Checkpoint c;
    c.utime = 123'456'789;
    c.ticks = {-17, std::int64_t{1} << 40};
    c.states = states;
    for (int i = 0; i < states; ++i) {
        c.state[i] = draw.uniform(-10, 10);
        for (int j = 0; j < states; ++j) c.covariance(i, j) = draw.uniform(-1, 1);
    }
    checkpoint_t message{};
    fill(message, c);
    message.seq = 7;
    message.version = "1.2.3";
    return message;
}

std::string unpack_error(const Bytes& bytes) {
    return complaint<std::runtime_error>([&] { (void)unpack(bytes); });
}

TEST(CheckpointFileTest, ComesBackBitForBit) {
    for (const int states : {3, 6}) {
        const checkpoint_t message = message_of(states);
        const checkpoint_t back = unpack(pack(message));
        EXPECT_EQ(bytes_of(back), bytes_of(message));
        const Checkpoint c = checkpoint_of(back), expected = checkpoint_of(message);
        EXPECT_EQ(c.utime, 123'456'789);
        EXPECT_TRUE(c.ticks == (EncoderTicks{-17, std::int64_t{1} << 40}));
        EXPECT_EQ(c.states, states);
        EXPECT_TRUE(same_bits(c.state, expected.state));
        EXPECT_TRUE(same_bits(c.covariance, expected.covariance));
        EXPECT_EQ(c.covariance(states - 1, 0),
                  message.covariance[static_cast<std::size_t>(states - 1)][0]);
    }
}

TEST(CheckpointFileTest, AnyFlippedBitIsFound) {
    const Bytes good = pack(message_of(6));
    for (std::size_t bit = 0; bit < 8 * good.size(); ++bit) {
        Bytes bad = good;
        bad[bit / 8] = static_cast<std::uint8_t>(bad[bit / 8] ^ (1U << bit % 8));
        ASSERT_EQ(unpack_error(bad), "is damaged: its CRC is wrong") << "bit " << bit;
    }
}

TEST(CheckpointFileTest, AnyTruncationAndAnyTailIsFound) {
    const Bytes good = pack(message_of(3));
    for (std::size_t size = 0; size < good.size(); ++size)
        ASSERT_NE(
            unpack_error(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size))), "")
            << size << " bytes";
    EXPECT_EQ(unpack_error({}), "is too short");
    Bytes longer = good;
    longer.push_back(0);
    EXPECT_NE(unpack_error(longer), "");
}

/// CRC-32 as everybody computes it, so that other programs can check the file.
TEST(CheckpointFileTest, EndsWithTheCrc32OfTheMessage) {
    const Bytes good = pack(message_of(3));
    std::uint32_t remainder = 0xFFFFFFFF;  // of the message with its CRC: a constant of CRC-32
    const auto take = [&](std::uint8_t byte) {
        for (int bit = 0; bit < 8; ++bit, byte = static_cast<std::uint8_t>(byte >> 1)) {
            const bool one = ((remainder ^ byte) & 1U) != 0;
            remainder = (remainder >> 1) ^ (one ? 0xEDB88320U : 0U);
        }
    };
    for (std::size_t i = 0; i < good.size() - 4; ++i) take(good[i]);
    for (std::size_t i = 1; i <= 4; ++i) take(good[good.size() - i]);  // stored big-endian
    EXPECT_EQ(remainder, 0xDEBB20E3U);
}

/// Whole and with a good CRC, but of another type: a program of other messages wrote it.
TEST(CheckpointFileTest, OfAnotherVersionSaysSo) {
    const Bytes good = pack(message_of(3));
    for (const std::size_t at : {std::size_t{0}, std::size_t{7}}) {
        Bytes bytes(good.begin(), good.end() - 4);
        bytes[at] = static_cast<std::uint8_t>(bytes[at] + 1);
        std::uint32_t crc = 0xFFFFFFFF;
        for (std::uint8_t byte : bytes)
            for (int bit = 0; bit < 8; ++bit, byte = static_cast<std::uint8_t>(byte >> 1))
                crc = (crc >> 1) ^ (((crc ^ byte) & 1U) != 0 ? 0xEDB88320U : 0U);
        crc = ~crc;
        for (int shift = 24; shift >= 0; shift -= 8)
            bytes.push_back(static_cast<std::uint8_t>(crc >> shift));
        EXPECT_EQ(unpack_error(bytes), "is of another version of this program");
    }
}

TEST(CheckpointFileTest, AnotherNumberOfStatesIsRefused) {
    for (const int n : {0, 1, 2, 4, 5, 7, 1000}) {
        checkpoint_t message = message_of(3);
        message.n = n;
        const auto size = static_cast<std::size_t>(n);
        message.state.assign(size, 0);
        message.covariance.assign(size, std::vector<double>(size, 0));
        EXPECT_NE(complaint<std::runtime_error>([&] { (void)checkpoint_of(message); }), "") << n;
    }
}

TEST(CheckpointFileTest, AFileIsReadAsItWasWrittenAndReplacedAsAWhole) {
    const Folder folder;
    const std::string path = folder.path("checkpoint");
    EXPECT_TRUE(read_bytes(path).empty()) << "there is none yet";
    const Bytes one = pack(message_of(3)), two = pack(message_of(6));
    replace_file(path, one);
    EXPECT_EQ(read_bytes(path), one);
    replace_file(path, two);
    EXPECT_EQ(read_bytes(path), two);
    replace_file(path, one);
    EXPECT_EQ(read_bytes(path), one) << "a shorter one leaves no tail";
    EXPECT_EQ(folder.read("checkpoint.new"), "") << "and nothing beside it";
    EXPECT_FALSE(std::filesystem::exists(folder.path("checkpoint.new")));
}

/// Whoever reads meanwhile sees one or the other.
TEST(CheckpointFileTest, WhileItIsReplacedAReaderSeesTheOldOrTheNewOne) {
    const Folder folder;
    const std::string path = folder.path("checkpoint");
    const Bytes contents[] = {Bytes(50'000, 1), Bytes(90'000, 2)};
    replace_file(path, contents[0]);
    std::thread writer([&] {
        for (int i = 1; i <= 40; ++i) replace_file(path, contents[i % 2]);
    });
    int whole = 0;
    for (int i = 0; i < 400; ++i) {
        const Bytes now = read_bytes(path);
        whole += now == contents[0] || now == contents[1] ? 1 : 0;
    }
    writer.join();
    EXPECT_EQ(whole, 400);
}

TEST(CheckpointFileTest, WhatCannotBeWrittenLeavesTheOldOneAndSaysWhy) {
    const Folder folder;
    const std::string path = folder.path("checkpoint");
    const Bytes old = pack(message_of(3));
    replace_file(path, old);
    std::filesystem::create_directory(path + ".new");  // in the way
    const std::string why =
        complaint<std::runtime_error>([&] { replace_file(path, pack(message_of(6))); });
    EXPECT_NE(why.find("cannot create"), std::string::npos) << why;
    EXPECT_NE(why.find(path), std::string::npos) << why;
    EXPECT_EQ(read_bytes(path), old);
    EXPECT_NE(complaint<std::runtime_error>([&] { replace_file(folder.path("no/such"), old); }),
              "");
    EXPECT_NE(complaint<std::runtime_error>([&] { (void)read_bytes(path + ".new"); }), "")
        << "a folder is no checkpoint";
}

/// The engine's own, over a restart.
TEST(CheckpointFileTest, AnEngineBeginsWhereAnotherEnded) {
    const std::string robot = std::string(kPlainRobot);
    Bench before("", robot);
    Journey journey(kPlainMap);
    before.run(journey.go(12, 0.1, 0.2));
    ASSERT_EQ(before.poses.back().status, status_t::OK);
    ASSERT_GE(before.checkpoints.size(), 2U) << "one every 5 s";
    before.engine().make_checkpoint();
    const Bytes checkpoint = before.checkpoints.back();

    const std::string waiting = R"(
motion: {heading: wheels}
sensors: {camera: {}}
map: [{id: 1, x: 6, y: 2, z: 0.4}, {id: 2, x: 4, y: -4}]
)";
    Bench after("", robot);
    after.engine().restore(checkpoint);
    journey.camera = false;
    after.run(journey.go(0.1));
    EXPECT_EQ(after.poses.front().status, status_t::OK) << "its wheels have not moved";
    EXPECT_NEAR(after.poses.front().x, before.poses.back().x, 1e-3);

    Bench changed("", waiting);
    changed.engine().restore(checkpoint);
    EXPECT_NEAR(changed.engine().estimate().pose[kX], before.poses.back().x, 1e-9)
        << "another configuration keeps the pose";
    Bench elsewhere("", "motion: {heading: wheels}\nmap: [{id: 1, x: 7, y: 2}]\n");
    EXPECT_EQ(complaint<std::runtime_error>([&] { elsewhere.engine().restore(checkpoint); }),
              "belongs to another map");
    EXPECT_FALSE(elsewhere.engine().estimate().status != Status::waiting);
    Bytes damaged = checkpoint;
    damaged[20] ^= 1;
    EXPECT_NE(complaint<std::runtime_error>([&] { elsewhere.engine().restore(damaged); }), "");
}

}  // namespace
}  // namespace pilotage::test
