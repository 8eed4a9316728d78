// What a platform's allocator is told; as platform.h, one source a system.
#pragma once

namespace braitenlab {

// Lets freed memory stay with the process, up to some megabytes. A world frees and allocates Box2D's memory at each
// keyframe, and glibc gives it back to the system each time: then most of the time of a short run is that of page
// faults. Call it once, first.
void keep_freed_memory();

}  // namespace braitenlab
