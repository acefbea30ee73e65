// Loops on all cores.
// The result of a loop must not depend on the number of threads: iterations write to places of their own.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace airlight {

// Calls body(i) once for each i in [0, count), in any order, on all cores.
void parallel_for(std::size_t count, const std::function<void(std::size_t)>& body);

// While it lives, loops use at most `threads` threads (>= 1).
class ThreadLimit {
public:
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

}  // namespace airlight
