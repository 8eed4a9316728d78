// Shader programs from files; errors carry file and line.
#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"

namespace braitenlab::render {

// A linked program. Precondition until destruction: a current GL context.
class Program {
public:
    // Compiles and links files of the folder, each preceded by a #version line (GLSL 330 or ESSL 300) and common.glsl;
    // binds the uniform block `Frame` to 0. An empty name means no geometry shader. Errors carry the file and line of
    // the first error in the driver's log.
    static Result<Program> load(const std::filesystem::path& folder, const std::string& vertex_file,
                                const std::string& fragment_file, const std::string& geometry_file = {});

    Program() = default;
    Program(Program&& other) noexcept : id_(other.id_) { other.id_ = 0; }
    Program& operator=(Program&& other) noexcept;
    ~Program();

    void use() const;

private:
    explicit Program(unsigned id) : id_(id) {}
    unsigned id_ = 0;
};

// The first error in a compiler's log; line 0 when the log has no line.
struct Complaint {
    int line = 0;
    std::string what;
};
Complaint first_complaint(const std::string& log);

}  // namespace braitenlab::render
