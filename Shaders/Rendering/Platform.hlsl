// Differences between graphics APIs.
#ifndef RILL_PLATFORM_INCLUDED
#define RILL_PLATFORM_INCLUDED

#if defined(SHADER_API_GLCORE) || defined(SHADER_API_GLES3)
#define RILL_OPENGL 1       // clip space is -1 to 1 in z, 1 is far, and textures begin at the bottom
// Depth of a fragment program that goes no nearer than what is drawn: a device can leave out what is hidden before it runs.
#define RILL_CONSERVATIVE_DEPTH SV_DepthGreaterEqual
#else
#define RILL_OPENGL 0       // 1 is near, and textures begin at the top
#define RILL_CONSERVATIVE_DEPTH SV_DepthLessEqual
#endif

#endif
