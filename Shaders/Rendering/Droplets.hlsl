// Droplets are the water that is thinner than its mesh can hold: each particle that flies by itself is a dozen of them, of its volume together,
// drawn out along their path while the picture is exposed. Those that are small on the picture, or so large that they would have burst, are added
// up by WaterSpray.compute, the others are drawn one by one by WaterDrops.hlsl.
//
//   _SurfaceElements  in  see SurfaceElement.hlsl
//   _MeshDrops        in  uint, indices of those that are drops
// Include after SurfaceView.hlsl, DrawnDomain.hlsl and what defines eyeIndex.
#ifndef RILL_DROPLETS_INCLUDED
#define RILL_DROPLETS_INCLUDED

#include "SurfaceParticle.hlsl"
#include "SurfaceElement.hlsl"
#include "../Gpu/Hash.hlsl"
#include "../Generated/SurfaceMesh.hlsl"

StructuredBuffer<SurfaceParticle> _SurfaceElements;
ByteAddressBuffer _MeshDrops;
float4 _FrameExposure;          // x: substeps while which the picture is exposed

static const float kSmallestDroplet = 0.45;     // radius of the last of a particle's droplets over the first
static const float kFirstRadius = 0.3694;       // of the first, d: with those radii all together have a volume of d^3
static const float kSpread = 1.1;               // of a particle's droplets around it, d
static const float kSmall = 6.0;                // radius up to which a droplet is added up with others, texels
// Radius up to which drops stay whole, m. Falling ones burst from 0.003 on (Villermaux and Bossa 2009), more than a particle is ever seen as.
static const float kMaxDropRadius = 0.01;
static const float kOnSolid = 0.8;              // nearer to a collider or a wall a particle lies on it, d
// A particle that lies there is a cap of a ball, with a contact angle of 40 degrees and a volume of d^3: radius of the ball and of the cap, d;
// distance of the ball's center below the solid over its radius.
static const float kCapBall = 1.848, kCapRadius = 1.188, kCapSunk = 0.766;
static const float kGathered = 0.066;           // part of the light from everywhere that a ball of water mirrors (Preisendorfer 1976)

struct Droplet
{
    float3 center;          // d, in the domain's frame, as is what follows
    float3 axis;            // unit
    float along, across;    // semi-axes of all that it covers in the exposure, d; 0 of those that are not drawn
    float shown;            // part of the exposure for which it covers a point of that
    float texel;            // width of a texel of the spray's textures there, d
    bool isCap;             // the part of it that is further along the axis than kCapSunk of its radius
};

float3 HashedInBall(uint id, uint k)
{
    return pow(UnitFloat(Hash(id, k, 3u)), 1.0 / 3.0) * UnitVector(Hash(id, k, 1u), Hash(id, k, 2u));
}

// Width of a texel of the spray's textures at a point of the domain, d.
float SprayTexel(float3 position)
{
    float4 clip = SurfaceClip(mul(_DomainToWorld, float4(position, 1.0)).xyz, eyeIndex);
    return TexelHeight(_FoamSize, max(DepthAlongView(clip, eyeIndex), 1e-6), eyeIndex) / Spacing();
}

// index: kDroplets to a drop.
Droplet DropletOf(uint index)
{
    Droplet droplet = (Droplet)0;
    uint k = index % kDroplets;
    SurfaceParticle drop = _SurfaceElements[_MeshDrops.Load(4 * (index / kDroplets))];
    uint id = drop.a.w;
    float3 chord = float3(UnpackHalves(drop.b.y), UnpackHalves(drop.b.z).x);
    float toSolid = UnpackHalves(drop.b.z).y;
    float3 position = asfloat(drop.a.xyz) + chord * _FrameLag.x;
    droplet.texel = SprayTexel(position);
    float radius = kFirstRadius * pow(kSmallestDroplet, k / (kDroplets - 1.0));     // a power law
    droplet.center = clamp(position + kSpread * HashedInBall(id, k), radius, _DrawnDomainSize.xyz - radius);
    // It covers as much of the picture as one that stands still, but along its path.
    float flown = length(chord) * _FrameExposure.x;
    droplet.along = radius + 0.5 * flown;
    droplet.across = radius;
    droplet.shown = radius / droplet.along;
    droplet.axis = flown > 1e-4 ? normalize(chord) : float3(0.0, 1.0, 0.0);
    if (toSolid < kOnSolid)
    {
        droplet.isCap = k == 0;
        droplet.axis = UnpackNormal(drop.b.w);
        droplet.center = position - droplet.axis * (toSolid + kCapBall * kCapSunk);
        droplet.along = droplet.across = droplet.isCap ? kCapBall : 0.0;
        droplet.shown = 1.0;
    }
    return droplet;
}

// Radius on the picture of one that stands still, d; 0 of those that are not drawn.
float RadiusOf(Droplet droplet)
{
    return droplet.isCap ? kCapRadius : droplet.across;
}

bool HasBurst(Droplet droplet)
{
    return !droplet.isCap && droplet.across * Spacing() > kMaxDropRadius;
}

// Whether it is drawn by itself: where it is whole and not small on the picture.
bool IsShown(Droplet droplet)
{
    return !HasBurst(droplet) && RadiusOf(droplet) >= kSmall * droplet.texel;
}

// Light that a ball of water sends on from a far light, mean over its disc, where a white surface that faces the light sends 1: what it mirrors
// and what is bent twice, by the angle between the directions of the light before and after (van de Hulst 1957, 12.2, for an index of 1.333).
// along: cosine of that angle.
float LightThroughBall(float along)
{
    float turned = 1.0 - along;
    float bent = 3.84 * exp(-10.6 * turned / (1.0 + 1.3 * turned - 0.88 * turned * turned));     // within 6 % up to 60 degrees
    float cosine = sqrt(saturate(0.5 - 0.5 * along));     // between the normal of what mirrors and both directions
    return bent + 0.25 * (0.02 + 0.98 * pow(1.0 - cosine, 5.0));
}

#endif
