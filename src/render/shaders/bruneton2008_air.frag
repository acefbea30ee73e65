#version 450 core
#include "bruneton2008_air.glsl"
#include "air_composite.glsl"
