#include "window.h"

#include <epoxy/gl.h>
// After the header that declares OpenGL.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <utility>

namespace airlight::cli {

namespace {

std::string reason() {
    const char* description = nullptr;
    glfwGetError(&description);
    return description ? description : "the window system gives no reason";
}

GLFWwindow* made_window(int width, int height, const std::string& title) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    return glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
}

void start_imgui(GLFWwindow* window) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;  // no file beside the user's
    ImGui::StyleColorsDark();
    ImGui::GetStyle().WindowRounding = 4.0f;
    ImGui::GetStyle().FrameRounding = 3.0f;
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 450 core");
}

double axis(int more, int less) { return (ImGui::IsKeyDown(more) ? 1.0 : 0.0) - (ImGui::IsKeyDown(less) ? 1.0 : 0.0); }

// What keys do, while no text is typed. `down` is which were down before; keys that were up again before the frame count as well.
void read_keys(GLFWwindow* window, std::set<int>& down, Input& input) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto pressed = [&](int key) {
        if (glfwGetKey(window, key) == GLFW_PRESS) return down.insert(key).second;
        down.erase(key);
        return false;
    };
    input.help = pressed(GLFW_KEY_F1), input.png = pressed(GLFW_KEY_F2), input.exr = pressed(GLFW_KEY_F3);
    const bool tab = pressed(GLFW_KEY_TAB), z = pressed(GLFW_KEY_Z), y = pressed(GLFW_KEY_Y), q = pressed(GLFW_KEY_Q);
    const bool k = pressed(GLFW_KEY_K), p = pressed(GLFW_KEY_P);
    if (io.WantTextInput) return;
    input.hide_panel = tab;
    if (io.KeyCtrl) {
        input.undo = z && !io.KeyShift, input.redo = y || (z && io.KeyShift), input.quit = q;
        return;
    }
    input.add_key = k, input.play = p;
    input.fast = io.KeyShift;
    input.steering = {.forward = axis(GLFW_KEY_W, GLFW_KEY_S), .right = axis(GLFW_KEY_D, GLFW_KEY_A), .up = axis(GLFW_KEY_E, GLFW_KEY_Q)};
}

// What the mouse does outside of panels: it drags the view, scrolls the speed, and clicks where nothing was dragged.
void read_mouse(Input& input) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!io.WantCaptureMouse) input.notches = static_cast<double>(io.MouseWheel);
    for (int button = 0; button < 2; ++button) {
        if (io.MouseDownOwned[button]) continue;
        if (ImGui::IsMouseDragging(button))
            input.dragged = {2.0 * static_cast<double>(io.MouseDelta.x / io.DisplaySize.x),
                             -2.0 * static_cast<double>(io.MouseDelta.y / io.DisplaySize.y)};
    }
    const float least = io.MouseDragThreshold;
    if (ImGui::IsMouseReleased(0) && !io.WantCaptureMouse && io.MouseDragMaxDistanceSqr[0] < least * least)
        input.clicked = {2.0 * static_cast<double>(io.MousePos.x / io.DisplaySize.x) - 1.0,
                         1.0 - 2.0 * static_cast<double>(io.MousePos.y / io.DisplaySize.y)};
}

}  // namespace

void Window::CloseLibrary::operator()(unsigned) const { glfwTerminate(); }
void Window::CloseWindow::operator()(GLFWwindow* window) const { glfwDestroyWindow(window); }
void Window::CloseImgui::operator()(unsigned) const {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

Result<Window> Window::open(int width, int height, const std::string& title) {
    if (!glfwInit())
        return Error{"airlight view", fmt::format("there is no display: {}.", reason()),
                     "Start it on a desktop, or under `xvfb-run`; `airlight render` draws without a window."};
    Window opened;
    opened.library_ = gpu::Handle<CloseLibrary>(1);
    opened.window_.reset(made_window(width, height, title));
    if (!opened.window_)
        return Error{"airlight view", fmt::format("the display offers no window with OpenGL 4.5: {}.", reason()),
                     "Update the driver, or draw in software with LIBGL_ALWAYS_SOFTWARE=1."};
    glfwMakeContextCurrent(opened.window_.get());
    Result<gpu::Context> context = gpu::Context::of_window();
    if (!context) return context.error();
    opened.context_ = std::move(*context);
    glfwSwapInterval(1);
    glfwSetInputMode(opened.window_.get(), GLFW_STICKY_KEYS, GLFW_TRUE);  // a short press of a slow frame is one
    start_imgui(opened.window_.get());
    opened.imgui_ = gpu::Handle<CloseImgui>(1);
    return opened;
}

bool Window::closed() const { return glfwWindowShouldClose(window_.get()); }

void Window::stay() { glfwSetWindowShouldClose(window_.get(), GLFW_FALSE); }

int Window::width() const {
    int width = 0;
    glfwGetFramebufferSize(window_.get(), &width, nullptr);
    return width;
}

int Window::height() const {
    int height = 0;
    glfwGetFramebufferSize(window_.get(), nullptr, &height);
    return height;
}

Input Window::begin_frame() {
    glfwPollEvents();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
    Input input;
    input.seconds = static_cast<double>(ImGui::GetIO().DeltaTime);
    read_keys(window_.get(), down_, input);
    read_mouse(input);
    return input;
}

void Window::draw_panels() {
    ImGui::Render();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_FRAMEBUFFER_SRGB);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

PngLevels Window::levels() const {
    PngLevels levels{width(), height(), 3, 8, {}};
    const std::size_t row_size = 3 * static_cast<std::size_t>(levels.width);
    std::vector<std::uint8_t> bytes(row_size * static_cast<std::size_t>(levels.height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, levels.width, levels.height, GL_RGB, GL_UNSIGNED_BYTE, bytes.data());
    for (std::size_t row = static_cast<std::size_t>(levels.height); row-- > 0;)
        levels.levels.insert(levels.levels.end(), &bytes[row * row_size], &bytes[row * row_size] + row_size);
    return levels;
}

void Window::show() { glfwSwapBuffers(window_.get()); }

}  // namespace airlight::cli
