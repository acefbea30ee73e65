// A sphere, a box or a cylinder, and where a ray meets it. All is relative to the eye and along the object's axes: what decides in float is
// then as small as the eye's way to the surface, not as large as the object. Half of this is solid_vertex.glsl, in double.
const int sphere = 0, box = 1;  // else a cylinder
struct Solid {
    int shape;
    mat3 axes;       // of length one
    vec3 low, high;  // faces of the box about it
    float beyond;    // of a sphere: square of the distance of its centre, less that of its radius; of a cylinder: of its axis
};

// A ray enters it at one distance and leaves it at the other; it does not meet it if the first is not less.
struct Crossing {
    float enters, leaves;
    vec3 normal;  // where it enters, along the object's axes
};

// The two roots t of t^2 - 2 b t + beyond; `root` is that of their discriminant. Neither is a small difference of large numbers.
vec2 roots(float b, float beyond, float root) {
    float far = b > 0.0 ? b + root : b - root;
    float other = far == 0.0 ? 0.0 : beyond / far;
    return b > 0.0 ? vec2(other, far) : vec2(far, other);
}

// Distances at which a ray of direction d, of length one in the dimensions that count, passes through a sphere or a circle whose centre stands
// at `centre` from its origin.
vec2 through_ball(vec3 centre, vec3 d, float radius, float beyond) {
    float b = dot(centre, d), beside = length(centre - b * d);
    // Near a large sphere its horizon is in the difference of two small squares, far from a small one in that of two short lengths.
    float square = abs(beyond) < radius * radius ? b * b - beyond : (radius - beside) * (radius + beside);
    return square > 0.0 ? roots(b, beyond, sqrt(square)) : vec2(1.0, 0.0);
}

// Those between three pairs of faces.
vec2 through_faces(vec3 low, vec3 high, vec3 d, out vec3 normal) {
    vec3 safe = mix(d, vec3(1e-20), lessThan(abs(d), vec3(1e-20))), a = low / safe, b = high / safe, first = min(a, b), last = max(a, b);
    float enters = max(first.x, max(first.y, first.z));
    normal = -sign(safe) * vec3(equal(first, vec3(enters)));
    return vec2(enters, min(last.x, min(last.y, last.z)));
}

// Of a ray from `origin`, which is relative to the eye, towards a direction of length one.
Crossing crossing(Solid s, vec3 origin, vec3 direction) {
    vec3 o = origin * s.axes, d = direction * s.axes, eye_to_centre = 0.5 * (s.low + s.high), centre = eye_to_centre - o;
    float radius = 0.5 * (s.high.x - s.low.x);
    Crossing c;
    if (s.shape == box) {
        vec2 way = through_faces(s.low - o, s.high - o, d, c.normal);
        c.enters = way.x, c.leaves = way.y;
        return c;
    }
    vec3 counts = s.shape == sphere ? vec3(1.0) : vec3(1.0, 1.0, 0.0);
    float flat_length = max(length(d * counts), 1e-20), beyond = s.beyond + dot(o * counts, o - 2.0 * eye_to_centre);
    vec2 way = through_ball(centre * counts, d * counts / flat_length, radius, beyond) / flat_length;
    c.enters = way.x, c.leaves = way.y;
    c.normal = (c.enters * d - centre) * counts / radius;
    if (s.shape == sphere) return c;
    vec3 end_normal;
    const float no_face = 1e30;
    vec2 between = through_faces(vec3(vec2(-no_face), s.low.z - o.z), vec3(vec2(no_face), s.high.z - o.z), d, end_normal);
    if (between.x > c.enters) c.enters = between.x, c.normal = end_normal;
    c.leaves = min(c.leaves, between.y);
    return c;
}
