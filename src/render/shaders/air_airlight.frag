#version 450 core
#include "air_airlight.glsl"
#include "air_composite.glsl"
