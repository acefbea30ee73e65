// The angle between two directions of length one. Not by acos, which near 0 is off by the root of its argument's rounding.
float angle_between(vec3 a, vec3 b) { return atan(length(cross(a, b)), dot(a, b)); }
