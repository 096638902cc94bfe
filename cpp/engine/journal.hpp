#pragma once
/// \file
/// Keeps the journal of a day's run readable: what changes often is said now and then.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <string>

namespace pilotage {

/// Lines about subjects. Each subject may say so many lines at once, then one a minute; of what it
/// could not say the newest line comes when it may, with the number left out.
class Journal {
   public:
    using Say = std::function<void(const std::string&)>;

    /// A subject's new line. \param at_once lines that this subject may say at once
    void note(const std::string& subject, const std::string& line, int at_once, std::int64_t now,
              const Say& say) {
        constexpr std::size_t enough = 1000;  // a peer that invents names does not fill the memory
        const auto at = subjects_.find(subject);
        if (at == subjects_.end() && subjects_.size() >= enough) return;
        Subject& s = at == subjects_.end()
                         ? subjects_.emplace(subject, Subject{at_once, at_once}).first->second
                         : at->second;
        s.waiting += s.line.empty() ? 0 : 1;
        s.line = line;
        flush(s, now, say);
    }

    /// Time passes: says what may be said by now.
    void flush(std::int64_t now, const Say& say) {
        for (auto& entry : subjects_) flush(entry.second, now, say);
    }

   private:
    static constexpr std::int64_t kEvery_us = 60'000'000;

    struct Subject {
        int at_once, tokens;
        std::int64_t refilled = 0;
        std::string line = {};
        int waiting = 0;  // lines left out since the last one said
    };

    static void flush(Subject& s, std::int64_t now, const Say& say) {
        if (s.tokens == s.at_once || now < s.refilled) s.refilled = now;
        if (const std::int64_t earned = (now - s.refilled) / kEvery_us; earned > 0) {
            s.tokens = static_cast<int>(std::min<std::int64_t>(s.at_once, s.tokens + earned));
            s.refilled += earned * kEvery_us;
        }
        if (s.line.empty() || s.tokens == 0) return;
        --s.tokens;
        const std::string more =
            s.waiting == 0 ? "" : " (and " + std::to_string(s.waiting) + " more like it)";
        say(s.line + more);
        s.line.clear();
        s.waiting = 0;
    }

    std::map<std::string, Subject> subjects_;
};

}  // namespace pilotage
