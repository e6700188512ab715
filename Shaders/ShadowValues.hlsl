// Where each of the uniforms of the Built-in pipeline's shadow lies in the copy that ShadowCopy.hlsl makes of them, texels of one row.
// ShadowCopy.cs knows how many there are. Includes nothing.
static const uint kWorldToShadow = 0;       // of four cascades, four rows each
static const uint kSplitSpheres = 16;       // four
static const uint kSplitSquaredRadii = 20;
static const uint kSplitsFar = 21;
static const uint kShadowData = 22;
static const uint kShadowFade = 23;
static const uint kShadowStamp = 24;        // x: which camera and frame they belong to
