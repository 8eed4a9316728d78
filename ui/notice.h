// What the lab has to say in a line at the bottom: that something was done, what a person had better know, or what
// could not be done and why. Each kind has a sign and a colour of its own.
#pragma once

#include <string>
#include <string_view>

#include "render/view/palette.h"
#include "ui/strings.h"

namespace braitenlab {

enum class NoticeKind { done, notice, failure };

struct Notice {
    NoticeKind kind = NoticeKind::notice;
    std::string key{};    // of what to say, in the language that is shown; empty: `words` stand as they are
    std::string words{};  // what fills its {}
    std::string more{};   // what fills a second one

    bool empty() const { return key.empty() && words.empty(); }
    friend bool operator==(const Notice&, const Notice&) = default;
};

std::string text_of(const Notice&, const Strings&);

// Of the icon font; and readable on the panel.
std::string_view sign_of(NoticeKind);
Colour colour_of(NoticeKind, const Palette&);

}  // namespace braitenlab
