#include "render/text/find_font.h"

#include <filesystem>

#ifdef BRAITENLAB_FONTCONFIG
#include <memory>

#include <fontconfig/fontconfig.h>
#endif

namespace braitenlab::render {

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
