// Characters rasterised at one size into one sheet of grey pixels, with their metrics.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/result.h"

namespace braitenlab::render {

// Path of a font file that contains the character; the default font for the character 0. Empty if there is none.
using FindFont = std::function<std::string(char32_t)>;

// Searches with fontconfig and prefers Noto Sans and DejaVu Sans. Without fontconfig, searches the usual paths of these
// fonts.
std::string find_font(char32_t);

// A character: its rectangle in the sheet and its offset from the pen; pixels, y down.
struct Glyph {
    int x = 0, y = 0, width = 0, height = 0;
    int left = 0, top = 0;  // from the pen on the baseline to the upper left corner; top is negative above the line
    float advance = 0;      // from this pen to the next character's
};

// The code points of a UTF-8 text; malformed bytes become U+FFFD.
std::u32string decode_utf8(std::string_view);

class Lettering {
public:
    static constexpr int side = 1024;  // px, side of the square sheet
    static constexpr int room = 2;     // px, empty margin around every character

    // Uses the default font of `find` at a size of `pixels`, and other fonts of `find` for characters that it lacks.
    // Error: no font is found, or the default font cannot be read.
    static Result<Lettering> from_fonts(const FindFont& find, int pixels);

    // Without fonts: only characters from add().
    explicit Lettering(int pixels);
    Lettering(Lettering&&) noexcept;
    Lettering& operator=(Lettering&&) noexcept;
    ~Lettering();

    // Adds a rasterised character: rows of `pitch` bytes, 0 background, 255 ink. False when the sheet is full.
    bool add(char32_t, int width, int height, const std::uint8_t* grey, int pitch, int left, int top, float advance);

    // The character, rasterised at its first use. A character that no font contains gives the font's replacement box or
    // an empty rectangle.
    const Glyph& glyph(char32_t);

    // Kerning between two characters, px; 0 without a kern table.
    float kerning(char32_t left, char32_t right);

    int pixels() const { return pixels_; }
    int cap_height();  // px, of a capital letter

    // The sheet, row by row from the top. take_changes() returns the rows changed since its last call.
    const std::vector<std::uint8_t>& sheet() const { return sheet_; }
    struct Rows {
        int first = 0, end = 0;  // rows first ≤ row < end
    };
    Rows take_changes();

private:
    struct Faces;
    bool rasterise(char32_t);

    int pixels_;
    std::unique_ptr<Faces> faces_;  // null without fonts
    std::unordered_map<char32_t, Glyph> glyphs_;
    std::vector<std::uint8_t> sheet_;
    int pen_x_ = 0, pen_y_ = 0, row_height_ = 0;  // position of the next character
    Rows changed_;
};

// A line of text: its characters with their pen positions, and its width; px.
struct SetCharacter {
    Glyph glyph;
    int x = 0;
};
struct SetLine {
    std::vector<SetCharacter> characters;
    int width = 0;
};
SetLine set_line(Lettering&, std::string_view utf8);

}  // namespace braitenlab::render
