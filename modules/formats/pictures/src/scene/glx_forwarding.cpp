// VTK's GLEW looks up OpenGL entry points through GLX. The GLX functions defined here precede those of libGL
// in the search order of this library and forward to OSMesa; they are not visible to the host program.

#include <cstring>

#include <GL/osmesa.h>

#define SCREE_GLX extern "C" __attribute__((visibility("default")))

using Function = void (*)();

SCREE_GLX void* glXGetCurrentDisplay() {
  static char any_address;
  return &any_address;
}

SCREE_GLX int glXQueryVersion(void*, int* major, int* minor) {
  *major = 1;
  *minor = 4;
  return 1;
}

SCREE_GLX const char* glXGetClientString(void*, int) { return ""; }

SCREE_GLX Function glXGetProcAddressARB(const unsigned char* name) {
  const char* symbol = reinterpret_cast<const char*>(name);
  if (std::strcmp(symbol, "glXGetCurrentDisplay") == 0)
    return reinterpret_cast<Function>(glXGetCurrentDisplay);
  return OSMesaGetProcAddress(symbol);
}

SCREE_GLX Function glXGetProcAddress(const unsigned char* name) { return glXGetProcAddressARB(name); }
