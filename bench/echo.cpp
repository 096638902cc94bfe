/// \file
/// The yardstick of the latency: a process that sends back what it receives, and nothing else.
/// `bench_echo URL`, ended by a signal.

#include <lcm/lcm.h>

#include <cstdio>

namespace {

void send_back(const lcm_recv_buf_t* buffer, const char*, void*) {
    lcm_publish(buffer->lcm, "ECHO", buffer->data, buffer->data_size);
}

}  // namespace

int main(int argc, char** argv) {
    lcm_t* lcm = argc == 2 ? lcm_create(argv[1]) : nullptr;
    if (lcm == nullptr) {
        std::fprintf(stderr, "usage: bench_echo URL, with a route for it\n");
        return 2;
    }
    lcm_subscribe(lcm, "ENCODERS", send_back, nullptr);
    while (lcm_handle(lcm) == 0) {
    }
}
