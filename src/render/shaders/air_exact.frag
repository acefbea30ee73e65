#version 450 core
#include "air_exact.glsl"
#include "air_composite.glsl"
