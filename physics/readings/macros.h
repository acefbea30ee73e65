// The few words of the shared text that C++ and GLSL spell differently, as C++ spells them.
// physics/readings/glsl.glsl is the other spelling. docs/decisions/0002-one-text.md has the rules.
#pragma once

#define FN inline
#define IN(T) const T&
#define OUT(T) T&
#define INOUT(T) T&
