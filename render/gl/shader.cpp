#include "render/gl/shader.h"

#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <sstream>
#include <utility>
#include <vector>

#include "render/gl/opengl.h"

namespace braitenlab::render {

namespace {

// Line number of the first line of common.glsl minus 1, set with #line: line numbers in a log then tell common.glsl
// from the shader's own file. (The second number of #line serves the same purpose, but Mesa 22 loses it for undeclared
// names.)
constexpr int common_lines = 10000;

#ifdef BRAITENLAB_OPENGL_ES
const char* const dialect = "#version 300 es\nprecision highp float;\nprecision highp int;\n";
constexpr GLenum geometry_stage = 0;  // there is none
#else
constexpr GLenum geometry_stage = GL_GEOMETRY_SHADER;
const char* const dialect = "#version 330 core\n";
#endif

std::optional<std::string> read(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return std::nullopt;
    return std::string(std::istreambuf_iterator<char>(in), {});
}

Error unreadable(const std::filesystem::path& file) {
    return {"cannot read the shader; install the shaders folder beside the program", file.string()};
}

// The driver's log of a shader or program. `ask` and `read` are the GL functions for that type of object.
template <class Ask, class Read>
std::string log_of(GLuint object, Ask ask, Read read) {
    GLint length = 0;
    ask(object, GL_INFO_LOG_LENGTH, &length);
    std::vector<char> text(static_cast<std::size_t>(length) + 1, '\0');
    read(object, length, nullptr, text.data());
    return text.data();
}

std::string log_of_shader(GLuint shader) { return log_of(shader, glGetShaderiv, glGetShaderInfoLog); }
std::string log_of_program(GLuint program) { return log_of(program, glGetProgramiv, glGetProgramInfoLog); }

Result<GLuint> compile_stage(GLenum stage, const std::filesystem::path& folder, const std::string& name) {
    const auto file = folder / name, common_file = folder / "common.glsl";
    const auto own = read(file), common = read(common_file);
    if (!own) return unreadable(file);
    if (!common) return unreadable(common_file);

    const std::string stage_name = stage == GL_VERTEX_SHADER     ? "#define VERTEX_STAGE\n"
                                   : stage == GL_FRAGMENT_SHADER ? "#define FRAGMENT_STAGE\n"
                                                                 : "#define GEOMETRY_STAGE\n";
    const std::string source =
        dialect + stage_name + "#line " + std::to_string(common_lines + 1) + "\n" + *common + "\n#line 1\n" + *own;
    const GLuint shader = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint good = GL_FALSE;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (good) return shader;

    const Complaint complaint = first_complaint(log_of_shader(shader));
    glDeleteShader(shader);
    const bool in_common = complaint.line > common_lines;
    return Error{"the shader does not compile; correct this line or reinstall the shaders: " + complaint.what,
                 (in_common ? common_file : file).string(), in_common ? complaint.line - common_lines : complaint.line};
}

}  // namespace

Complaint first_complaint(const std::string& log) {
    // Mesa "0:12(5): error: …", NVIDIA "0(12) : error C1008: …", AMD, Apple and ANGLE "ERROR: 0:12: …".
    static const std::regex shapes(R"((?:ERROR:\s*)?(\d+)(?::(\d+)(?:\(\d+\))?|\((\d+)\))\s*:\s*(.*))",
                                   std::regex::icase);
    std::istringstream lines(log);
    std::string line, first;
    std::optional<Complaint> any;
    while (std::getline(lines, line)) {
        if (first.empty()) first = line;
        std::smatch m;
        if (!std::regex_search(line, m, shapes)) continue;
        Complaint found{std::stoi(m[2].matched ? m[2] : m[3]), m[4]};
        const bool is_error = std::regex_search(line, std::regex("error", std::regex::icase));
        if (is_error) return found;
        if (!any) any = found;
    }
    return any ? *any : Complaint{0, first.empty() ? "the driver gives no reason" : first};
}

Result<Program> Program::load(const std::filesystem::path& folder, const std::string& vertex_file,
                              const std::string& fragment_file, const std::string& geometry_file) {
    const std::pair<GLenum, const std::string&> stages[] = {
        {GL_VERTEX_SHADER, vertex_file}, {geometry_stage, geometry_file}, {GL_FRAGMENT_SHADER, fragment_file}};
    Program program(glCreateProgram());
    for (const auto& [stage, name] : stages) {
        if (name.empty()) continue;
        const auto shader = compile_stage(stage, folder, name);
        if (!shader) return shader.error();
        glAttachShader(program.id_, *shader);
        glDeleteShader(*shader);  // GL deletes it together with the program
    }
    glLinkProgram(program.id_);
    GLint good = GL_FALSE;
    glGetProgramiv(program.id_, GL_LINK_STATUS, &good);
    if (!good)
        return Error{"does not link with " + fragment_file +
                         "; make the outputs of one match the inputs of the other: " +
                         first_complaint(log_of_program(program.id_)).what,
                     (folder / vertex_file).string()};
    const GLuint frame = glGetUniformBlockIndex(program.id_, "Frame");
    if (frame != GL_INVALID_INDEX) glUniformBlockBinding(program.id_, frame, 0);
    return program;
}

Program& Program::operator=(Program&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
}

Program::~Program() {
    if (id_) glDeleteProgram(id_);
}

void Program::use() const { glUseProgram(id_); }

}  // namespace braitenlab::render
