#include "ui/notice.h"

#include "ui/theme.h"
#include "ui/widgets/paint.h"

namespace braitenlab {

std::string text_of(const Notice& notice, const Strings& strings) {
    return notice.key.empty() ? notice.words : fill(strings(notice.key), {notice.words, notice.more});
}

std::string_view sign_of(NoticeKind kind) {
    switch (kind) {
        case NoticeKind::done:
            return icon::check;
        case NoticeKind::failure:
            return icon::warning;
        default:
            return icon::notice;
    }
}

Colour colour_of(NoticeKind kind, const Palette& p) {
    const Colour wanted = kind == NoticeKind::done ? p.success : kind == NoticeKind::failure ? p.warning : p.accent;
    return legible(wanted, p.panel, p.text);
}

}  // namespace braitenlab
