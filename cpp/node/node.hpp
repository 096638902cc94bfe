#pragma once
/// \file
/// The engine on LCM: receives, publishes, ticks and records.

#include <csignal>
#include <cstdint>
#include <memory>
#include <string>

#include "engine/engine.hpp"
#include "engine/event_log.hpp"
#include "file_keeper.hpp"
#include "options.hpp"

struct _lcm_t;
struct _lcm_recv_buf_t;

namespace pilotage {

class Node final : private EngineOutput {
   public:
    /// Subscribes to the inputs. \param lcm outlives the node
    /// \throws std::runtime_error if the recording cannot be opened
    Node(const Config& config, _lcm_t* lcm, const Options& options);
    Node(const Node&) = delete;
    Node& operator=(const Node&) = delete;
    ~Node() { engine_.make_checkpoint(); }

    /// Handles messages until `stop` is set. \return false if LCM failed
    bool run(const volatile std::sig_atomic_t& stop);

   private:
    void message(const std::string& channel, const std::uint8_t* data, std::size_t size) override;
    void notice(const std::string& text) override;
    void checkpoint(const Bytes& bytes) override;

    static void received(const _lcm_recv_buf_t* buffer, const char* channel, void* self);
    void tick(std::int64_t now);
    void say_what_is_missing();
    [[nodiscard]] Bytes restore(const std::string& path);
    void begin_recording(const std::string& path, const Bytes& checkpoint);
    void record(std::int64_t received, std::string_view channel, const std::uint8_t* data,
                std::size_t size);
    template <typename Action>
    void to_log(const Action& action);
    template <typename Message>
    void record(std::int64_t received, std::string_view channel, const Message& message);

    _lcm_t* lcm_;
    Engine engine_;
    std::unique_ptr<LogWriter> log_;
    std::unique_ptr<FileKeeper> checkpoints_;
    std::int64_t received_ = 0;
    std::int32_t ticks_ = 0;
    std::string missing_ = "?";
};

}  // namespace pilotage
