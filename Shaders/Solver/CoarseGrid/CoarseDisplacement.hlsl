// Looks up the displacement that the coarse grid gives a particle. Include after CoarseGrid.hlsl.
#ifndef RILL_COARSE_DISPLACEMENT_INCLUDED
#define RILL_COARSE_DISPLACEMENT_INCLUDED

StructuredBuffer<float4> _Displacements;    // [coarse cells], xyz at the cell's center, d

// Trilinear between the centers, constant beyond the outermost ones, and no longer than 'longest'.
float3 CoarseDisplacement(float3 p, float longest)
{
    float3 position = p * _InverseCoarseSize - 0.5;
    float3 lower = floor(position);
    float3 fraction = position - lower;
    int3 last = int3(_CoarseCounts) - 1;
    int3 a = clamp(int3(lower), 0, last);
    int3 b = clamp(int3(lower) + 1, 0, last);
    int strideY = _CoarseCounts.x;
    int strideZ = _CoarseCounts.x * _CoarseCounts.y;

    float3 sum = 0.0;
    [unroll]
    for (int corner = 0; corner < 4; corner++)
    {
        bool upperY = (corner & 1) != 0;
        bool upperZ = (corner & 2) != 0;
        int row = (upperZ ? b.z : a.z) * strideZ + (upperY ? b.y : a.y) * strideY;
        float weight = (upperY ? fraction.y : 1.0 - fraction.y) * (upperZ ? fraction.z : 1.0 - fraction.z);
        sum += weight * lerp(_Displacements[row + a.x].xyz, _Displacements[row + b.x].xyz, fraction.x);
    }
    float lengthSquared = dot(sum, sum);
    return lengthSquared > longest * longest ? sum * (longest * rsqrt(lengthSquared)) : sum;
}

static const float kAlone = 0.3;        // density relative to rest of a particle with a neighbor or two
static const float kCovered = 0.55;     // and of one on an edge of water at rest

// Displacement of a particle by the projection; velocity.w is its density. Displacements continue around the water, for particles between
// its last cells' centers and its surface; spray there is pressed by nothing, and would hover where they cancel gravity.
float3 ProjectedDisplacement(float3 p, float4 velocity)
{
    return saturate((velocity.w - kAlone) / (kCovered - kAlone)) * CoarseDisplacement(AlongFlow(p, velocity.xyz), _MaxFlow);
}

#endif
