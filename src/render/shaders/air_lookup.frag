#version 450 core
#include "air_lookup.glsl"
#include "air_composite.glsl"
