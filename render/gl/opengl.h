// OpenGL's functions: OpenGL 3.3 with GLEW, OpenGL ES 3.0 (WebGL 2) without it.
#pragma once

#ifdef BRAITENLAB_OPENGL_ES
#include <GLES3/gl3.h>
#else
#include <GL/glew.h>
#endif
