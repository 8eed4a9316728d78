// Characters drawn once, at one size, into one sheet of grey pixels, and how far apart they stand.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/result.h"
#include "render/text/find_font.h"

namespace braitenlab::render {

// Where a character stands in the sheet and how it lies about the pen, pixels, y down.
struct Glyph {
    int x = 0, y = 0, width = 0, height = 0;
    int left = 0, top = 0;  // from the pen on the baseline to the upper left corner; top is negative above the line
    float advance = 0;      // to the next character's pen
};

// Code points of UTF-8; what is malformed becomes U+FFFD.
std::u32string decode_utf8(std::string_view);

class Lettering {
public:
    static constexpr int side = 1024;  // pixels of the square sheet
    static constexpr int room = 2;     // empty pixels round every character

    // Draws with a font that is `pixels` high; characters it lacks come from the fonts that `find` knows for them.
    // Fails where there is no font at all.
    static Result<Lettering> from_fonts(const FindFont& find, int pixels);

    // Knows no character but those that are added.
    explicit Lettering(int pixels);
    Lettering(Lettering&&) noexcept;
    Lettering& operator=(Lettering&&) noexcept;
    ~Lettering();

    // A character drawn elsewhere: rows of `pitch` bytes, 0 nothing and 255 ink. False when the sheet is full.
    bool add(char32_t, int width, int height, const std::uint8_t* grey, int pitch, int left, int top, float advance);

    // Drawn into the sheet if it is not there yet. A character that nobody has is the font's empty box, or nothing.
    const Glyph& glyph(char32_t);

    // What the font's kern table moves the second of two characters by, pixels; 0 without one.
    float kerning(char32_t left, char32_t right);

    int pixels() const { return pixels_; }
    int cap_height();  // of a capital letter, pixels

    // The sheet's rows from the top, and those that changed since the last call.
    const std::vector<std::uint8_t>& sheet() const { return sheet_; }
    struct Rows {
        int first = 0, end = 0;  // nothing where equal
    };
    Rows take_changes();

private:
    struct Faces;
    bool rasterise(char32_t);

    int pixels_;
    std::unique_ptr<Faces> faces_;  // null without fonts
    std::unordered_map<char32_t, Glyph> glyphs_;
    std::vector<std::uint8_t> sheet_;
    int pen_x_ = 0, pen_y_ = 0, row_height_ = 0;  // where the next character goes
    Rows changed_;
};

// A line of text: its characters with the pen's place of each, and its width; pixels.
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
