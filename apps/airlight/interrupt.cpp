#include "interrupt.h"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <ctime>

namespace airlight::cli {

namespace {

sigset_t stopping_signals() {
    sigset_t signals;
    sigemptyset(&signals);
    sigaddset(&signals, SIGINT);
    sigaddset(&signals, SIGTERM);
    return signals;
}

}  // namespace

// A thread that waits for the signals, not a handler: in a handler hardly any call is allowed.
Interrupt::Interrupt() {
    const sigset_t signals = stopping_signals();
    ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
    listener_ = std::jthread([source = source_, signals](const std::stop_token& end) mutable {
        while (!end.stop_requested()) {
            const timespec patience{0, 100'000'000};  // so that the end of the job is noticed
            const int signal = ::sigtimedwait(&signals, nullptr, &patience);
            if (signal < 0) continue;
            if (source.stop_requested()) ::_exit(128 + signal);
            std::fputs("\nstopping; once more to stop at once\n", stderr);
            source.request_stop();
        }
    });
}

Interrupt::~Interrupt() {
    listener_.request_stop();
    listener_.join();
    const sigset_t signals = stopping_signals();
    ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

}  // namespace airlight::cli
