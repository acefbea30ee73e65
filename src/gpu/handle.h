// A name that OpenGL gave, deleted when its owner goes.
// Uses nothing.
#pragma once

#include <utility>

namespace airlight::gpu {

// Deleter::operator()(unsigned) gives the name back. It can be moved, not copied; 0 is no name.
template <class Deleter>
class Handle {
public:
    explicit Handle(unsigned name = 0) : name_(name) {}
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Handle() {
        if (name_) Deleter()(name_);
    }
    unsigned name() const { return name_; }

private:
    unsigned name_;
};

}  // namespace airlight::gpu
