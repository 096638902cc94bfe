#include "file_keeper.hpp"

#include <exception>
#include <utility>

namespace pilotage {

FileKeeper::FileKeeper(std::string path, std::function<void(const std::string&)> on_error)
    : path_(std::move(path)), on_error_(std::move(on_error)), thread_([this] { run(); }) {}

FileKeeper::~FileKeeper() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ended_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

void FileKeeper::put(const Bytes& content) {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        next_ = content;
        fresh_ = true;
    }
    changed_.notify_one();
}

void FileKeeper::run() {
    std::unique_lock<std::mutex> lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return fresh_ || ended_; });
        if (!fresh_) return;
        const Bytes content = next_;
        fresh_ = false;
        lock.unlock();
        try {
            replace_file(path_, content);
        } catch (const std::exception& error) {
            on_error_(error.what());
        }
        lock.lock();
    }
}

}  // namespace pilotage
