// Shaders: files beside the program, compiled once, their mistakes told with file and line.
#pragma once

#include <filesystem>
#include <string>

#include "core/result.h"

namespace braitenlab::render {

// A linked program; deleted with its owner. Needs a current context for its whole life.
class Program {
public:
    // Compiles and links files of the folder (no geometry shader where its name is empty), each after common.glsl of
    // the same folder, and ties the uniform block `Frame` to binding 0. The sources have no #version line: the loader
    // puts one before them, so that the same files serve GLSL 330 and ESSL 300. An error names the file and line that
    // the driver's log blames.
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

// The first error of a compiler's log and its line, 0 where the log does not say.
struct Complaint {
    int line = 0;
    std::string what;
};
Complaint first_complaint(const std::string& log);

}  // namespace braitenlab::render
