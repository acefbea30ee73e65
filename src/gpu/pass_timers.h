// How long each pass of a frame takes on the GPU, by its own clock.
// Uses core; knows no physics.
#pragma once

#include <string>
#include <vector>

#include "gpu/handle.h"

namespace airlight::gpu {

struct DeleteQuery {
    void operator()(unsigned name) const;
};

struct PassTime {
    std::string pass;
    double milliseconds;
};

class PassTimers {
public:
    // Times what is drawn while it lives; passes may lie within each other.
    class Pass {
    public:
        ~Pass();
        Pass(const Pass&) = delete;
        Pass& operator=(const Pass&) = delete;

    private:
        friend class PassTimers;
        explicit Pass(unsigned end) : end_(end) {}
        unsigned end_;
    };
    [[nodiscard]] Pass time(std::string pass);

    // The passes since the last read, in the order of their beginnings; waits for the GPU. All have ended.
    std::vector<PassTime> read();

private:
    struct Stamps {
        std::string pass;
        Handle<DeleteQuery> begin, end;
    };
    std::vector<Stamps> passes_;
};

}  // namespace airlight::gpu
