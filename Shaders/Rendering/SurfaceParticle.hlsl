// A particle of the water's surface, as SurfaceParticles.compute writes it and renderers read it: an ellipsoid of 32 bytes.
// Lengths in d, in the domain's frame.
#ifndef RILL_SURFACE_PARTICLE_INCLUDED
#define RILL_SURFACE_PARTICLE_INCLUDED

//   a.xyz  float bits of the center at the newest state
//   a.w    index of the particle, for what is kept by particle
//   b.x    orientation, see PackRotation; of a disc its normal, see PackNormal
//   b.y    half2, semi-axes 0 and 1; the second is negative where it is a disc, whose semi-axes 0 and 1 are equal
//   b.z    half2, semi-axis 2 and x of the chord
//   b.w    half2, y and z of the chord
#include "../Generated/SurfaceParticle.hlsl"

static const float kRotationRange = 0.70710678;     // largest magnitude of the components that are stored

uint PackHalves(float low, float high)
{
    return f32tof16(low) | f32tof16(high) << 16;
}

float2 UnpackHalves(uint packed)
{
    return float2(f16tof32(packed & 0xFFFFu), f16tof32(packed >> 16));
}

// -1 to 1, 16 bits each.
uint PackSnorm(float2 v)
{
    uint2 bits = uint2(int2(round(clamp(v, -1.0, 1.0) * 32767.0))) & 0xFFFFu;
    return bits.x | bits.y << 16;
}

// A unit vector on an octahedron (Meyer et al. 2010), 16 bits each.
uint PackNormal(float3 normal)
{
    float3 n = normal / max(abs(normal.x) + abs(normal.y) + abs(normal.z), 1e-10);
    float2 folded = (1.0 - abs(n.yx)) * float2(n.x < 0.0 ? -1.0 : 1.0, n.y < 0.0 ? -1.0 : 1.0);
    float2 unfolded = n.z < 0.0 ? folded : n.xy;
    return PackSnorm(unfolded);
}

float3 UnpackNormal(uint packed)
{
    int2 bits = int2(packed << 16, packed) >> 16;
    float2 unfolded = float2(bits) / 32767.0;
    float3 n = float3(unfolded, 1.0 - abs(unfolded.x) - abs(unfolded.y));
    float fold = saturate(-n.z);
    n.xy += float2(n.x < 0.0 ? fold : -fold, n.y < 0.0 ? fold : -fold);
    return normalize(n);
}

// The quaternion of the rotation whose matrix has these rows: three perpendicular unit vectors, right-handed.
float4 RotationOf(float3 x, float3 y, float3 z)
{
    // Four times the square of each component; of the largest, so that nothing cancels.
    float4 squares = 1.0 + float4(x.x - y.y - z.z, y.y - x.x - z.z, z.z - x.x - y.y, x.x + y.y + z.z);
    float3 sums = float3(y.z + z.y, z.x + x.z, x.y + y.x);
    float3 differences = float3(y.z - z.y, z.x - x.z, x.y - y.x);
    float4 q = float4(differences, squares.w);
    float largest = squares.w;
    if (squares.x > largest)
    {
        largest = squares.x;
        q = float4(squares.x, sums.z, sums.y, differences.x);
    }
    if (squares.y > largest)
    {
        largest = squares.y;
        q = float4(sums.z, squares.y, sums.x, differences.y);
    }
    if (squares.z > largest)
    {
        largest = squares.z;
        q = float4(sums.y, sums.x, squares.z, differences.z);
    }
    return q * rsqrt(max(dot(q, q), 1e-20));
}

// The three smaller components of a unit quaternion in 10 bits each; the highest two bits say which one is left out.
uint PackRotation(float4 q)
{
    float4 size = abs(q);
    uint largest = 0;
    float most = size.x;
    if (size.y > most)
    {
        largest = 1;
        most = size.y;
    }
    if (size.z > most)
    {
        largest = 2;
        most = size.z;
    }
    if (size.w > most)
        largest = 3;
    float left = largest == 0 ? q.x : largest == 1 ? q.y : largest == 2 ? q.z : q.w;
    float3 kept = largest == 0 ? q.yzw : largest == 1 ? q.xzw : largest == 2 ? q.xyw : q.xyz;
    kept *= left < 0.0 ? -1.0 : 1.0;        // q and -q turn alike
    uint3 bits = uint3(clamp(round(kept * (511.0 / kRotationRange)) + 511.0, 0.0, 1022.0));
    return largest << 30 | bits.x << 20 | bits.y << 10 | bits.z;
}

float4 UnpackRotation(uint packed)
{
    uint3 bits = uint3(packed >> 20, packed >> 10, packed) & 1023u;
    float3 kept = (float3(bits) - 511.0) * (kRotationRange / 511.0);
    float left = sqrt(max(1.0 - dot(kept, kept), 0.0));
    uint largest = packed >> 30;
    return largest == 0 ? float4(left, kept) : largest == 1 ? float4(kept.x, left, kept.yz) : largest == 2 ? float4(kept.xy, left, kept.z)
        : float4(kept, left);
}

// The rows of a unit quaternion's matrix, see RotationOf.
float3x3 RotationRows(float4 q)
{
    float3 twice = 2.0 * q.xyz;
    float3 squares = twice * q.xyz;
    float3 products = float3(twice.x * q.y, twice.y * q.z, twice.z * q.x);     // 2xy, 2yz, 2zx
    float3 turns = twice * q.w;
    return float3x3(1.0 - squares.y - squares.z, products.x + turns.z, products.z - turns.y,
        products.x - turns.z, 1.0 - squares.x - squares.z, products.y + turns.x,
        products.z + turns.y, products.y - turns.x, 1.0 - squares.x - squares.y);
}

// rows: unit vectors along the semi-axes, perpendicular, right-handed.
SurfaceParticle PackSurface(float3 center, uint index, float3x3 rows, float3 semiAxes, float3 chord)
{
    SurfaceParticle particle;
    particle.a = uint4(asuint(center), index);
    particle.b = uint4(PackRotation(RotationOf(rows[0], rows[1], rows[2])), PackHalves(semiAxes.x, semiAxes.y),
        PackHalves(semiAxes.z, chord.x), PackHalves(chord.y, chord.z));
    return particle;
}

// A disc turned around its normal looks the same: what the turn would take is left to the normal. In PackRotation's bits one step is
// 0.16 degrees, which is seen where the normal moves slowly.
SurfaceParticle PackDisc(float3 center, uint index, float3 normal, float radius, float height, float3 chord)
{
    SurfaceParticle particle;
    particle.a = uint4(asuint(center), index);
    particle.b = uint4(PackNormal(normal), PackHalves(radius, -radius), PackHalves(height, chord.x), PackHalves(chord.y, chord.z));
    return particle;
}

bool IsDisc(SurfaceParticle particle)
{
    return UnpackHalves(particle.b.y).y < 0.0;
}

// Two unit vectors at right angles to a third and to each other.
void TangentsOf(float3 normal, out float3 x, out float3 y)
{
    float3 aside = abs(normal.x) < 0.6 ? float3(1, 0, 0) : float3(0, 1, 0);
    x = normalize(cross(aside, normal));
    y = cross(normal, x);
}

// axes: its rows are the semi-axes as vectors, d. chord: displacement in the last substep, d.
void UnpackSurface(SurfaceParticle particle, out float3 center, out float3x3 axes, out uint index, out float3 chord)
{
    center = asfloat(particle.a.xyz);
    index = particle.a.w;
    float2 first = UnpackHalves(particle.b.y);
    float2 second = UnpackHalves(particle.b.z);
    chord = float3(second.y, UnpackHalves(particle.b.w));
    float3 semiAxes = float3(first.x, abs(first.y), second.x);
    if (first.y < 0.0)
    {
        axes[2] = UnpackNormal(particle.b.x);
        TangentsOf(axes[2], axes[0], axes[1]);
    }
    else
    {
        axes = RotationRows(UnpackRotation(particle.b.x));
    }
    axes[0] *= semiAxes.x;
    axes[1] *= semiAxes.y;
    axes[2] *= semiAxes.z;
}

#endif
