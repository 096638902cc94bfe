#pragma once
/// \file
/// Messages in memory in the order of their arrival, as an LCM log holds them on disk.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine.hpp"
#include "event_log.hpp"

namespace pilotage {

class Recording {
   public:
    /// Reads a log, over damaged places. \throws std::runtime_error
    [[nodiscard]] static Recording load(const std::string& path);
    /// \throws std::runtime_error
    void save(const std::string& path) const;

    void add(std::int64_t received, std::string_view channel, const std::uint8_t* data,
             std::size_t size);

    /// Encodes and adds a message of an lcm-gen type.
    template <typename Message>
    void add(std::int64_t received, std::string_view channel, const Message& message) {
        encode(message, buffer_);
        add(received, channel, buffer_.data(), buffer_.size());
    }

    /// By time of arrival; messages that arrived at once stay in the order in which they were
    /// added.
    void sort();

    [[nodiscard]] std::size_t size() const noexcept { return events_.size(); }
    [[nodiscard]] LogEvent operator[](std::size_t i) const noexcept;
    [[nodiscard]] const std::vector<std::string>& damage() const noexcept { return damage_; }

   private:
    struct Place {
        std::int64_t received;
        std::size_t offset;
        std::uint32_t size;
        std::uint32_t channel;
    };
    std::vector<Place> events_;
    std::vector<std::uint8_t> bytes_;
    std::vector<std::string> channels_;
    std::vector<std::string> damage_;
    std::vector<std::uint8_t> buffer_;
};

}  // namespace pilotage
