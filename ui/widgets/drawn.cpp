#include "ui/widgets/drawn.h"

#include <functional>
#include <string_view>

#include "ui/imgui_compat.h"

namespace braitenlab::ui {

std::optional<std::uint64_t> hash_of_drawn(const ImDrawData& drawn) {
    if (compat::changes_textures(drawn)) return std::nullopt;
    std::uint64_t hash = 0;
    const auto add = [&](const void* bytes, std::size_t size) {
        hash = 31 * hash + std::hash<std::string_view>()({static_cast<const char*>(bytes), size});
    };
    for (int i = 0; i < drawn.CmdListsCount; ++i) {
        const ImDrawList& list = *drawn.CmdLists[i];
        add(list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
        add(list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.size_in_bytes()));
        for (const ImDrawCmd& part : list.CmdBuffer) {
            const ImTextureID texture = part.GetTexID();
            add(&part.ClipRect, sizeof part.ClipRect);
            add(&part.ElemCount, sizeof part.ElemCount);
            add(&texture, sizeof texture);
            add(&part.UserCallbackData, sizeof part.UserCallbackData);
        }
    }
    return hash;
}

}  // namespace braitenlab::ui
