#include "gpu/sampler.h"

#include <epoxy/gl.h>

namespace airlight::gpu {

namespace {

unsigned create(Filter filter, Wrap wrap) {
    GLuint name = 0;
    glCreateSamplers(1, &name);
    const GLint how = filter == Filter::linear ? GL_LINEAR : GL_NEAREST, beyond = wrap == Wrap::repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, how);
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, how);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) glSamplerParameteri(name, axis, beyond);
    return name;
}

}  // namespace

void DeleteSampler::operator()(unsigned name) const { glDeleteSamplers(1, &name); }

Sampler::Sampler(Filter filter, Wrap wrap) : handle_(create(filter, wrap)) {}

void Sampler::bind(unsigned binding) const { glBindSampler(binding, name()); }

void Sampler::unbind(unsigned binding) { glBindSampler(binding, 0); }

}  // namespace airlight::gpu
