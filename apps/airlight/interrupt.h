// Ctrl-C as a wish to stop: the job at work ends soon, says so, and keeps what it has finished.
#pragma once

#include <stop_token>
#include <thread>

namespace airlight::cli {

// While it lives, SIGINT and SIGTERM ask token() to stop, each said on standard error; a second one ends the program at once.
// Make it before any other thread starts: threads inherit that these signals wait for it.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    std::stop_token token() const { return source_.get_token(); }

private:
    std::stop_source source_;
    std::jthread listener_;
};

}  // namespace airlight::cli
