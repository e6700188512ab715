// The depth of the water's mesh before its colors: whatever the order of its triangles, the nearest face alone is shaded, and where it does
// not refract, blended once. Includes nothing of Unity's.
#include "View.hlsl"
#include "SurfaceView.hlsl"
#include "WaterMesh.hlsl"

float4 WaterDepthFragment(WaterVaryings input) : SV_Target
{
    return 0.0;
}
