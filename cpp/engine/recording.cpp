#include "recording.hpp"

#include <algorithm>

namespace pilotage {

Recording Recording::load(const std::string& path) {
    Recording recording;
    LogReader reader(path);
    LogEvent event;
    while (reader.next(event)) recording.add(event.received, event.channel, event.data, event.size);
    recording.damage_ = reader.damage();
    return recording;
}

void Recording::save(const std::string& path) const {
    LogWriter writer(path);
    for (std::size_t i = 0; i < size(); ++i) writer.write((*this)[i]);
    writer.flush();
}

void Recording::add(std::int64_t received, std::string_view channel, const std::uint8_t* data,
                    std::size_t size) {
    const auto known = std::find(channels_.begin(), channels_.end(), channel);
    const auto number = static_cast<std::uint32_t>(known - channels_.begin());
    if (known == channels_.end()) channels_.emplace_back(channel);
    events_.push_back({received, bytes_.size(), static_cast<std::uint32_t>(size), number});
    bytes_.insert(bytes_.end(), data, data + size);
}

void Recording::sort() {
    std::stable_sort(events_.begin(), events_.end(),
                     [](const Place& a, const Place& b) { return a.received < b.received; });
}

LogEvent Recording::operator[](std::size_t i) const noexcept {
    const Place& place = events_[i];
    return {place.received, channels_[place.channel], bytes_.data() + place.offset, place.size};
}

}  // namespace pilotage
