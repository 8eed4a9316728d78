#include "render/text/lettering.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <utility>

#include <ft2build.h>
#include FT_FREETYPE_H
#ifdef BRAITENLAB_FONTCONFIG
#include <fontconfig/fontconfig.h>
#endif

#include "core/utf8.h"

namespace braitenlab::render {

// The FreeType library and its open faces, the default font first.
struct Lettering::Faces {
    FT_Library library = nullptr;
    FindFont find;
    std::vector<std::pair<std::string, FT_Face>> open;

    Faces() = default;
    Faces(const Faces&) = delete;
    Faces& operator=(const Faces&) = delete;
    ~Faces() {
        for (const auto& [file, face] : open) FT_Done_Face(face);
        if (library) FT_Done_FreeType(library);
    }

    FT_Face face_from(const std::string& file, int pixels) {
        for (const auto& [name, face] : open)
            if (name == file) return face;
        FT_Face face = nullptr;
        if (file.empty() || FT_New_Face(library, file.c_str(), 0, &face) != 0) return nullptr;
        if (FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(pixels)) != 0) {
            FT_Done_Face(face);
            return nullptr;
        }
        open.push_back({file, face});
        return face;
    }

    // The first open face with the character, else one found by the system, else the default font.
    FT_Face face_for(char32_t c, int pixels) {
        for (const auto& [name, face] : open)
            if (FT_Get_Char_Index(face, c) != 0) return face;
        const FT_Face found = face_from(find(c), pixels);
        return found && FT_Get_Char_Index(found, c) != 0 ? found : open.front().second;
    }
};

std::u32string decode_utf8(std::string_view text) {
    std::u32string decoded;
    while (!text.empty()) {
        const CodePoint first = first_code_point(text);
        decoded += first.code;
        text.remove_prefix(first.size);
    }
    return decoded;
}

Result<Lettering> Lettering::from_fonts(const FindFont& find, int pixels) {
    Lettering made(pixels);
    made.faces_ = std::make_unique<Faces>();
    made.faces_->find = find;
    if (FT_Init_FreeType(&made.faces_->library) != 0)
        return Error{"FreeType cannot be initialised; reinstall the program"};
    const std::string usual = find(0);
    if (usual.empty()) return Error{"no font for labels was found; install fonts-noto-core or fonts-dejavu-core"};
    if (!made.faces_->face_from(usual, pixels))
        return Error{"this font file cannot be read; reinstall the font", usual};
    return made;
}

Lettering::Lettering(int pixels) : pixels_(pixels), sheet_(static_cast<std::size_t>(side) * side, 0) {}
Lettering::Lettering(Lettering&&) noexcept = default;
Lettering& Lettering::operator=(Lettering&&) noexcept = default;
Lettering::~Lettering() = default;

bool Lettering::add(char32_t c, int width, int height, const std::uint8_t* grey, int pitch, int left, int top,
                    float advance) {
    if (pen_x_ + width + 2 * room > side) pen_x_ = 0, pen_y_ += std::exchange(row_height_, 0);
    if (width + 2 * room > side || pen_y_ + height + 2 * room > side) return false;
    const Glyph glyph{pen_x_ + room, pen_y_ + room, width, height, left, top, advance};
    for (int row = 0; row < height; ++row)
        std::copy_n(grey + row * pitch, width,
                    sheet_.begin() + static_cast<std::ptrdiff_t>(glyph.y + row) * side + glyph.x);
    glyphs_[c] = glyph;
    pen_x_ += width + 2 * room;
    row_height_ = std::max(row_height_, height + 2 * room);
    const bool clean = changed_.first == changed_.end;
    changed_ = {clean ? pen_y_ : std::min(changed_.first, pen_y_),
                std::max(clean ? 0 : changed_.end, pen_y_ + height + 2 * room)};
    return true;
}

bool Lettering::rasterise(char32_t c) {
    const FT_Face face = faces_->face_for(c, pixels_);
    if (FT_Load_Char(face, c, FT_LOAD_RENDER | FT_LOAD_TARGET_LIGHT) != 0) return false;
    const FT_GlyphSlot slot = face->glyph;
    const FT_Bitmap& bitmap = slot->bitmap;
    if (bitmap.pixel_mode != FT_PIXEL_MODE_GRAY && bitmap.rows > 0) return false;
    return add(c, static_cast<int>(bitmap.width), static_cast<int>(bitmap.rows), bitmap.buffer, bitmap.pitch,
               slot->bitmap_left, -slot->bitmap_top, static_cast<float>(slot->advance.x) / 64);
}

const Glyph& Lettering::glyph(char32_t c) {
    static const Glyph nothing;
    if (const auto found = glyphs_.find(c); found != glyphs_.end()) return found->second;
    if (!faces_ || !rasterise(c)) return glyphs_[c] = nothing;
    return glyphs_[c];
}

float Lettering::kerning(char32_t left, char32_t right) {
    if (!faces_) return 0;
    const FT_Face face = faces_->face_for(left, pixels_);
    if (!FT_HAS_KERNING(face) || face != faces_->face_for(right, pixels_)) return 0;
    FT_Vector moved{};
    if (FT_Get_Kerning(face, FT_Get_Char_Index(face, left), FT_Get_Char_Index(face, right), FT_KERNING_UNFITTED,
                       &moved) != 0)
        return 0;
    return static_cast<float>(moved.x) / 64;
}

int Lettering::cap_height() { return -glyph(U'H').top; }

Lettering::Rows Lettering::take_changes() { return std::exchange(changed_, {}); }

SetLine set_line(Lettering& lettering, std::string_view utf8) {
    SetLine line;
    float pen = 0;
    std::optional<char32_t> before;
    for (const char32_t c : decode_utf8(utf8)) {
        if (before) pen += lettering.kerning(*before, c);
        const Glyph& glyph = lettering.glyph(c);
        // Whole pixels keep characters as sharp as they were rasterised.
        line.characters.push_back({glyph, static_cast<int>(std::lround(pen))});
        pen += glyph.advance;
        before = c;
    }
    line.width = static_cast<int>(std::lround(pen));
    return line;
}

#ifdef BRAITENLAB_FONTCONFIG

std::string find_font(char32_t c) {
    if (!FcInit()) return {};
    const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> wanted(FcPatternCreate(), &FcPatternDestroy);
    for (const char* family : {"Noto Sans", "DejaVu Sans", "sans-serif"})
        FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
    FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
    if (c != 0) {
        const std::unique_ptr<FcCharSet, decltype(&FcCharSetDestroy)> characters(FcCharSetCreate(), &FcCharSetDestroy);
        FcCharSetAddChar(characters.get(), c);
        FcPatternAddCharSet(wanted.get(), FC_CHARSET, characters.get());
    }
    FcConfigSubstitute(nullptr, wanted.get(), FcMatchPattern);
    FcDefaultSubstitute(wanted.get());
    FcResult result = FcResultNoMatch;
    const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> found(FcFontMatch(nullptr, wanted.get(), &result),
                                                                        &FcPatternDestroy);
    FcChar8* file = nullptr;
    if (!found || FcPatternGetString(found.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
    return reinterpret_cast<const char*>(file);
}

#else

std::string find_font(char32_t) {
    for (const char* file :
         {"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf", "/usr/share/fonts/noto/NotoSans-Regular.ttf",
          "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", "/usr/share/fonts/dejavu/DejaVuSans.ttf",
          "C:/Windows/Fonts/segoeui.ttf"})
        if (std::filesystem::exists(file)) return file;
    return {};
}

#endif

}  // namespace braitenlab::render
