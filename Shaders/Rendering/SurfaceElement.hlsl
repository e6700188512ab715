// A particle of the water's surface as the mesh takes it, in the 32 bytes of a SurfaceParticle. Lengths in d, in the domain's frame. Include
// SurfaceParticle.hlsl first.
#ifndef RILL_SURFACE_ELEMENT_INCLUDED
#define RILL_SURFACE_ELEMENT_INCLUDED

//   a.xyz  float bits of the particle's position
//   a.w    normal of its plane, see PackNormal; of a drop the particle's id
//   b.x    half depth of the particle below the plane; 8 bits trust in the plane; 8 bits kind
//   b.y    offset of the ellipsoid's center, 10 bits each; of a drop half2, x and y of its chord
//   b.z    orientation of the ellipsoid, see PackRotation; of a drop half2, z of its chord and its distance from the nearest collider or wall
//   b.w    semi-axes, 10 bits each; of a drop the normal of that, see PackNormal

static const uint kNoElement = 0;
static const uint kSurfaceElement = 1;      // a piece of the mesh
static const uint kWallElement = 2;         // water that touches a wall, where there may be no surface but the wall
static const uint kDropElement = 3;         // what is thinner than the mesh can hold

static const float kElementOffset = 1.5;    // largest component of an offset that is stored
static const float kElementSemiAxis = 1.5;  // and largest semi-axis

struct SurfaceElement
{
    uint kind;
    float3 position;
    float3 normal;      // unit, out of the water
    float depth;        // of the particle below the plane
    float trust;        // 1: the plane alone is the surface; 0: the ellipsoid alone
    float3 offset;      // from the particle to the ellipsoid's center
    float4 rotation;    // quaternion, see RotationOf
    float3 semiAxes;
};

uint PackTenBits(float3 v)      // 0 to 1
{
    uint3 bits = uint3(round(saturate(v) * 1023.0));
    return bits.x << 20 | bits.y << 10 | bits.z;
}

float3 UnpackTenBits(uint packed)
{
    return float3(uint3(packed >> 20, packed >> 10, packed) & 1023u) / 1023.0;
}

SurfaceParticle PackElement(SurfaceElement e)
{
    SurfaceParticle packed;
    packed.a = uint4(asuint(e.position), PackNormal(e.normal));
    packed.b = uint4(f32tof16(e.depth) | uint(round(saturate(e.trust) * 255.0)) << 16 | e.kind << 24,
        PackTenBits(e.offset / (2.0 * kElementOffset) + 0.5), PackRotation(e.rotation), PackTenBits(e.semiAxes / kElementSemiAxis));
    return packed;
}

// An element without a shape.
SurfaceParticle PackElement(uint kind, float3 position)
{
    SurfaceParticle packed;
    packed.a = uint4(asuint(position), 0);
    packed.b = uint4(kind << 24, 0, 0, 0);
    return packed;
}

// Packs a particle whose plane is unknown.
SurfaceParticle PackBall(float3 position, float radius)
{
    SurfaceElement ball = (SurfaceElement)0;
    ball.kind = kSurfaceElement;
    ball.position = position;
    ball.normal = float3(0.0, 1.0, 0.0);
    ball.rotation = float4(0.0, 0.0, 0.0, 1.0);
    ball.semiAxes = radius;
    return PackElement(ball);
}

// chord: displacement in the last substep, d. contact: xyz normal of what is nearest to it, w its distance, d.
SurfaceParticle PackDrop(float3 position, uint id, float3 chord, float4 contact)
{
    SurfaceParticle packed;
    packed.a = uint4(asuint(position), id);
    packed.b = uint4(kDropElement << 24, PackHalves(chord.x, chord.y), PackHalves(chord.z, contact.w), PackNormal(contact.xyz));
    return packed;
}

uint KindOf(SurfaceParticle packed)
{
    return packed.b.x >> 24;
}

SurfaceElement UnpackElement(SurfaceParticle packed)
{
    SurfaceElement e;
    e.kind = KindOf(packed);
    e.position = asfloat(packed.a.xyz);
    e.normal = UnpackNormal(packed.a.w);
    e.depth = f16tof32(packed.b.x & 0xFFFFu);
    e.trust = (packed.b.x >> 16 & 255u) / 255.0;
    e.offset = (UnpackTenBits(packed.b.y) - 0.5) * (2.0 * kElementOffset);
    e.rotation = UnpackRotation(packed.b.z);
    e.semiAxes = UnpackTenBits(packed.b.w) * kElementSemiAxis;
    return e;
}

#endif
