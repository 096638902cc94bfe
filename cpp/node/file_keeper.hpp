#pragma once
/// \file
/// Keeps a file up to date without making anybody wait for the disk.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

#include "engine/checkpoint_file.hpp"

namespace pilotage {

/// Writes the newest content given to it, each time as a whole (replace_file). What was not yet
/// written when newer content comes is left out; the last content is written before it ends.
class FileKeeper {
   public:
    /// \param on_error hears, on the writing thread, what failed
    FileKeeper(std::string path, std::function<void(const std::string&)> on_error);
    FileKeeper(const FileKeeper&) = delete;
    FileKeeper& operator=(const FileKeeper&) = delete;
    ~FileKeeper();

    void put(const Bytes& content);

   private:
    void run();

    std::string path_;
    std::function<void(const std::string&)> on_error_;
    std::mutex mutex_;
    std::condition_variable changed_;
    Bytes next_;
    bool fresh_ = false, ended_ = false;
    std::thread thread_;
};

}  // namespace pilotage
