#include "core/lesson/exercise_fields.h"
#include "core/scene/format_table.h"

namespace braitenlab {

std::string describe_exercise_format() {
    FormatTable<Exercise> table("", "The top of the file", "");
    describe(table, Of<Exercise>{});
    return table.text();
}

}  // namespace braitenlab
