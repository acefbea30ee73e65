#version 450 core
// One triangle over the whole picture.
layout(location = 0) out vec2 place;  // x to the right, y up, from -1 to 1
void main() {
    place = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(place, 0.0, 1.0);
}
