// Links: a scene with its brains, or the name of a shipped exercise, as the part of an address after '#'. A browser
// does not send this part to the server, so a shared scene is stored in the link alone.
//
// "#b1." and the text of the scene's file: compressed (zlib), then in the characters A-Z a-z 0-9 - _ (base64url, RFC
// 4648, without padding). "#e1." and the name of the exercise. The number is the version.
#pragma once

#include <string>
#include <string_view>

#include "core/result.h"
#include "core/scene/scene.h"

namespace braitenlab::io {

// Some chat programs cut a link after the first, most after the second number of characters.
inline constexpr std::size_t safe_link = 2000, longest_useful_link = 8000;

// True for a text that is an address with '#' and a link of any version, or such a link alone. White space around it is
// ignored. The link may still be broken.
bool is_link(std::string_view text);

// True for a text that begins like a link alone, whatever follows: the address of a page may end in a broken one.
bool begins_like_link(std::string_view text);

// The link of a scene, or of a shipped exercise by its name ("05-aggressor"), from '#' on.
std::string encode_link(const Scene&);
std::string encode_exercise_link(std::string_view name);

// What a link holds.
struct Linked {
    std::string exercise;  // a name of the letters that a name may have; empty: a scene
    Scene scene{};         // valid, as parse_scene() returns it
};

// Reads a link with or without an address before '#'. Fails with the reason: no link, a later version, characters that
// a link does not have, an incomplete or damaged link (also one that is broken before its version), a scene larger
// than limits::file_bytes; and as parse_scene() does, with the line of the scene's text.
Result<Linked> decode_link(std::string_view text);

}  // namespace braitenlab::io
