#include "core/scene/format_table.h"

namespace braitenlab {

std::string describe_scene_format() {
    FormatTable<Scene> table("", "The top of the file", "");
    describe(table, Of<Scene>{});
    return table.text();
}

}  // namespace braitenlab
