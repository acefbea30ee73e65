#include "gpu/pass_timers.h"

#include <epoxy/gl.h>

#include <utility>

namespace airlight::gpu {

namespace {

unsigned create() {
    GLuint name = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &name);
    return name;
}

GLuint64 nanoseconds(unsigned query) {
    GLuint64 stamp = 0;
    glGetQueryObjectui64v(query, GL_QUERY_RESULT, &stamp);
    return stamp;
}

}  // namespace

void DeleteQuery::operator()(unsigned name) const { glDeleteQueries(1, &name); }

PassTimers::Pass::~Pass() { glQueryCounter(end_, GL_TIMESTAMP); }

PassTimers::Pass PassTimers::time(std::string pass) {
    passes_.push_back({std::move(pass), Handle<DeleteQuery>(create()), Handle<DeleteQuery>(create())});
    glQueryCounter(passes_.back().begin.name(), GL_TIMESTAMP);
    return Pass(passes_.back().end.name());
}

std::vector<PassTime> PassTimers::read() {
    std::vector<PassTime> times;
    for (const Stamps& p : passes_)
        times.push_back({p.pass, static_cast<double>(nanoseconds(p.end.name()) - nanoseconds(p.begin.name())) * 1e-6});
    passes_.clear();
    return times;
}

}  // namespace airlight::gpu
