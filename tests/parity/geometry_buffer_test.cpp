// The geometry buffer at planet scale: a position rebuilt from depth, and a normal read back; beside them, linear depth and
// normals of 8 bits as in [Sperlhofer2011, section 4.3]. The figures of docs/decisions/0008-geometry-buffer.md.

#include <doctest/doctest.h>
#include <epoxy/gl.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <vector>

#include "gpu/vertex_array.h"
#include "render/camera_block.h"
#include "render/geometry_buffer.h"
#include "render/shaders.h"
#include "terrain/cube_sphere.h"
#include "terrain/octahedral.h"
#include "tools/gpu_case.h"

using namespace airlight;
using namespace airlight::test;

namespace {

constexpr int side = 64;

gpu::Program program_of(const std::string& vertex, const std::string& fragment) {
    const auto with_files = [](const std::string& text) {
        const std::filesystem::path root = std::filesystem::path(AIRLIGHT_SOURCE_DIR) / "src/render/shaders";
        return *gpu::resolve_includes("#version 450 core\n" + text, root);
    };
    const gpu::Stage stages[] = {{GL_VERTEX_SHADER, with_files(vertex)}, {GL_FRAGMENT_SHADER, with_files(fragment)}};
    Result<gpu::Program> program = gpu::Program::link("test", stages);
    if (!program) FAIL(program.error().message());
    return std::move(*program);
}

// The thesis' planes: the nearest and the farthest that is seen, on one planet.
constexpr double thesis_near_m = 0.5, thesis_far_m = 45e6;

// A wall across the view whose middle is `distance_m` away: at a place (x, y) of the picture its distance along the axis is
// distance / (1 + tilt.x x + tilt.y y).
struct Wall {
    double distance_m;
    double tilt_x, tilt_y;
    double along_axis_m(double x, double y) const { return distance_m / (1.0 + tilt_x * x + tilt_y * y); }
};

Camera test_camera() {
    Camera camera = look(Vec3(0.0), glm::normalize(Vec3(1.0, 0.3, -0.2)), Vec3(0, 0, 1));
    camera.width = camera.height = side;
    return camera;
}

Vec3 ray(const Camera& c, double x, double y) {
    const HalfSize half = half_size(c);
    return c.forward + x * half.width * c.right + y * half.height * c.up;
}

// Two triangles a little larger than the picture.
gpu::Buffer vertices_of(const Wall& wall, const Camera& camera) {
    std::vector<float> floats;
    for (const auto& [x, y] : {std::pair{-1.1, -1.1}, {1.1, -1.1}, {1.1, 1.1}, {-1.1, -1.1}, {1.1, 1.1}, {-1.1, 1.1}}) {
        const Vec3 p = ray(camera, x, y) * wall.along_axis_m(x, y);
        for (int c = 0; c < 3; ++c) floats.push_back(static_cast<float>(p[c]));
    }
    return gpu::Buffer(std::as_bytes(std::span(floats)));
}

struct Errors {
    double ours = 0.0, linear24 = 0.0, linear32 = 0.0;
};

// The two ways to draw a wall and to rebuild what was drawn.
class Depths {
public:
    Depths() { camera_block_.bind(camera_); }

    // The largest error of a position, as a share of its distance.
    Errors errors(const Wall& wall) const {
        return {error(wall, draw_ours_, rebuild_ours_, reversed_, 0.0f, GL_GREATER),
                error(wall, draw_linear_, rebuild_linear_, linear24_, 1.0f, GL_LESS),
                error(wall, draw_linear_, rebuild_linear_, linear32_, 1.0f, GL_LESS)};
    }

private:
    double error(const Wall& wall, const gpu::Program& draw, const gpu::Program& rebuild, const gpu::Texture& depth, float cleared,
                 GLenum nearer) const {
        const Result<gpu::Framebuffer> target = gpu::Framebuffer::create({}, &depth), seen = gpu::Framebuffer::create({&positions_});
        REQUIRE(target);
        REQUIRE(seen);
        target->bind();
        target->clear_depth(cleared);
        glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(nearer);
        draw.use();
        const gpu::Buffer vertices = vertices_of(wall, camera_);
        gpu::VertexArray(vertices, 3 * sizeof(float), {{0, 3, 0}}).draw_triangles(6);
        glDisable(GL_DEPTH_TEST);
        seen->bind();
        rebuild.use();
        depth.bind_sampler(0);
        gpu::VertexArray().draw_triangles(3);
        std::vector<float> rebuilt(4 * side * side);
        positions_.read(rebuilt);
        return largest_error(wall, rebuilt);
    }

    double largest_error(const Wall& wall, const std::vector<float>& rebuilt) const {
        double largest = 0.0;
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const double x = (column + 0.5) / side * 2.0 - 1.0, y = (row + 0.5) / side * 2.0 - 1.0;
                const Vec3 exact = ray(camera_, x, y) * wall.along_axis_m(x, y);
                const float* p = &rebuilt[static_cast<std::size_t>(4 * (row * side + column))];
                largest = std::max(largest, glm::length(Vec3(p[0], p[1], p[2]) - exact) / glm::length(exact));
            }
        return largest;
    }

    Camera camera_ = test_camera();
    render::CameraBlock camera_block_;
    gpu::Texture reversed_{{side, side}, {}, gpu::TextureFormat::depth32f}, linear24_{{side, side}, {}, gpu::TextureFormat::depth24},
        linear32_{{side, side}, {}, gpu::TextureFormat::depth32f}, positions_{{side, side}};
    gpu::Program draw_ours_ = program_of(R"(#include "camera.glsl"
layout(location = 0) in vec3 p;
void main() { gl_Position = clip_position(p); }
)",
                                         "void main() {}\n");
    gpu::Program rebuild_ours_ = program_of(fullscreen, R"(#include "camera.glsl"
layout(binding = 0) uniform sampler2D depth;
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 position;
void main() { position = vec4(position_at(place, texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r), 1.0); }
)");
    // Listing 4-8: a usual projection whose depth is then multiplied by w / far.
    gpu::Program draw_linear_ = program_of(fmt::format(R"(#include "camera.glsl"
layout(location = 0) in vec3 p;
const float near = {0}, far = {1:.1f};
void main() {{
    gl_Position = clip_position(p);
    gl_Position.z = far / (far - near) * gl_Position.w - near * far / (far - near);
    gl_Position.z *= gl_Position.w / far;
}}
)",
                                                       thesis_near_m, thesis_far_m),
                                           "void main() {}\n");
    // Equation 4-3.
    gpu::Program rebuild_linear_ = program_of(fullscreen, fmt::format(R"(#include "camera.glsl"
layout(binding = 0) uniform sampler2D depth;
layout(location = 0) in vec2 place;
layout(location = 0) out vec4 position;
const float near = {0}, far = {1:.1f};
void main() {{
    vec3 camera_to_near = view_ray(place) * near, near_to_far = view_ray(place) * (far - near);
    position = vec4(camera_to_near + texelFetch(depth, ivec2(gl_FragCoord.xy), 0).r * near_to_far, 1.0);
}}
)",
                                                                      thesis_near_m, thesis_far_m));
    static constexpr const char* fullscreen = R"(layout(location = 0) out vec2 place;
void main() {
    place = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    gl_Position = vec4(place, 0.0, 1.0);
}
)";
};

}  // namespace

// Float leaves 2^-24 in each of: the vertices, their depth, its interpolation over a wall that is four times as far on one side as
// on the other, the ray, the quotient. 1e-6 is five times their sum. The task asks for 1e-4.
TEST_CASE("a position rebuilt from reversed depth is right to a millionth of its distance, from 1 m to 40 000 km") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Depths depths;
    fmt::print("  error / distance        facing the eye                    slanted\n  {:>12}  {:>9} {:>9} {:>9}   {:>9} {:>9} {:>9}\n",
               "distance, m", "reversed", "linear24", "linear32", "reversed", "linear24", "linear32");
    for (const double distance_m : {1.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e7, 4e7}) {
        const Errors facing = depths.errors({distance_m, 0.0, 0.0}), slanted = depths.errors({distance_m, 0.4, 0.2});
        fmt::print("  {:>12.0f}  {:>9.1e} {:>9.1e} {:>9.1e}   {:>9.1e} {:>9.1e} {:>9.1e}\n", distance_m, facing.ours, facing.linear24,
                   facing.linear32, slanted.ours, slanted.linear24, slanted.linear32);
        CHECK(facing.ours <= 1e-6);
        CHECK(slanted.ours <= 1e-6);
        // The thesis' depth: steps of far / 2^24, 2.7 m; and a depth made linear before the division by w is bent between vertices.
        if (distance_m < 1e4) CHECK(facing.linear24 > 1e-4);
        if (distance_m > 1e2 && distance_m < 4e7) CHECK(slanted.linear32 > 0.1);
    }
}

TEST_CASE("normals: two numbers of 16 bits are hundreds of times closer than three of 8 bits, in the same four bytes") {
    const GpuCase gpu_case;
    if (!gpu_case) return;
    const Result<render::GeometryBuffer> buffer = render::GeometryBuffer::create(side, side);
    REQUIRE(buffer);
    const gpu::Texture thesis({side, side}, {}, gpu::TextureFormat::rgba8), exact({side, side});
    // Directions spread over the sphere, one a pixel.
    const std::string direction = R"(
vec3 direction() {
    float n = gl_FragCoord.x - 0.5 + 64.0 * (gl_FragCoord.y - 0.5);
    float z = (n + 0.5) / 2048.0 - 1.0, turn = 2.399963 * n, s = sqrt(1.0 - z * z);
    return vec3(s * cos(turn), s * sin(turn), z);
}
)";
    const std::string fullscreen = R"(void main() {
    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.5, 1.0);
}
)";
    buffer->begin();
    program_of(fullscreen, "#include \"geometry_buffer.glsl\"\n" + direction +
                               "void main() { write_surface(vec3(0.25, 0.5, 1.0), direction(), 0.5, 1.0); }\n")
        .use();
    gpu::VertexArray().draw_triangles(3);
    render::GeometryBuffer::end();
    const Result<gpu::Framebuffer> other = gpu::Framebuffer::create({&thesis, &exact});
    REQUIRE(other);
    other->bind();
    glDisable(GL_FRAMEBUFFER_SRGB);
    program_of(fullscreen, direction + "layout(location = 0) out vec4 bits8;\nlayout(location = 1) out vec4 all;\n" +
                               "void main() { all = vec4(direction(), 0.0); bits8 = 0.5 * all + 0.5; }\n")
        .use();
    gpu::VertexArray().draw_triangles(3);

    std::vector<float> two(2 * side * side), three(4 * side * side), truth(4 * side * side), colour(4 * side * side),
        material(2 * side * side);
    buffer->normal().read(two);
    thesis.read(three);
    exact.read(truth);
    buffer->colour().read(colour);
    buffer->material().read(material);
    double ours = 0.0, theirs = 0.0, light = 0.0;
    for (std::size_t i = 0; i < side * side; ++i) {
        const Vec3 d(truth[4 * i], truth[4 * i + 1], truth[4 * i + 2]);
        const auto level = [](float x) { return static_cast<std::uint32_t>(std::lround(x * 65535.0f)); };
        ours = std::max(ours, angle_between(glm::normalize(d), from_octahedral(level(two[2 * i]) | level(two[2 * i + 1]) << 16)));
        const Vec3 bits8 = 2.0 * Vec3(three[4 * i], three[4 * i + 1], three[4 * i + 2]) - 1.0;
        theirs = std::max(theirs, angle_between(glm::normalize(d), glm::normalize(bits8)));
        // A sun of 5 degrees over the horizon: what the thesis' normal, not made of length one again, does to its light.
        light =
            std::max(light, std::abs(glm::dot(bits8, glm::normalize(Vec3(1, 0.3, 0.1))) - glm::dot(d, glm::normalize(Vec3(1, 0.3, 0.1)))));
        CHECK(std::abs(colour[4 * i + 1] - 0.7354f) <= 0.6f / 255.0f);  // 0.5 through sRGB's curve
        CHECK(colour[4 * i + 3] == 1.0f);
        CHECK(std::abs(material[2 * i] - 0.5f) <= 0.5f / 255.0f * 1.001f);
        CHECK(material[2 * i + 1] == 1.0f);
    }
    fmt::print("  largest error of a normal: {:.4f} degrees; with 8 bits {:.3f} degrees, and {:.4f} of the sun's light\n", ours / deg,
               theirs / deg, light);
    CHECK(ours < 0.004 * deg);
    CHECK(theirs > 50.0 * ours);
}
