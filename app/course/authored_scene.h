// The scene from which an exercise was made.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "app/document.h"

namespace braitenlab {

struct AuthoredScene {
    Document scene;                          // as it was saved; empty after edit_again()
    std::string vehicle;                     // ExerciseDraft::vehicle
    std::filesystem::path path;              // of the exercise
    std::optional<std::uint64_t> content{};  // of its file, when the author saved it last or agreed to replace it
    std::uint64_t exercise_run = 0;          // Document::run_id of the exercise; 0 after edit_again()
    std::uint64_t restored_run = 0;          // Document::run_id of the scene after edit_again(); 0 before
};

// True if this exercise was made here, and its scene is kept. `authored`: of the exercise made last; may be null.
inline bool has_draft(const AuthoredScene* authored, const Document& open) {
    return authored && authored->exercise_run == open.run_id;
}

}  // namespace braitenlab
