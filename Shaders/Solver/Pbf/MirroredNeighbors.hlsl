// Visits the neighbors of a particle and their images in the walls of the domain, and WITH_COLLIDERS in the plane at which the nearest
// collider is touched. Before it is included there must be
//   Sums, Neighbor                                           what is added up, and what of
//   void AddNeighbor(inout Sums, Plane own, Neighbor)
//   uint2 PlaneOf(uint j)                                    read along with a neighbor
// and kLanes, the threads that divide the neighbors of a particle: each visits its part of them; WITH_COLLIDERS Contact.hlsl.
#ifndef RILL_MIRRORED_NEIGHBORS_INCLUDED
#define RILL_MIRRORED_NEIGHBORS_INCLUDED

static const float kMirrorReach = 1.5;      // a wall further away mirrors nothing that is a neighbor, d
static const float kFacing = 0.7;           // cosine from which a collider stands before a wall, whose images lie in it

// Whose neighbors are visited.
struct Particle
{
    uint index;
    float3 position;    // d
    Plane own;
    uint lane;          // of the thread
#ifdef WITH_COLLIDERS
    float4 contact;     // with the nearest collider: xyz its normal, w the distance
#endif
};

Particle ParticleOf(uint index, float3 position, Plane own, uint lane)
{
    Particle particle;
    particle.index = index;
    particle.position = position;
    particle.own = own;
    particle.lane = lane;
#ifdef WITH_COLLIDERS
    particle.contact = ContactOf(index);
#endif
    return particle;
}

// Image to visit: the water itself, or one mirror image of it.
struct Mirror
{
    bool isImage;
    bool3 flips;        // axes along which it is mirrored
    float3 walls;       // along them, an image lies at this minus the position; d
    bool isInCollider;  // mirrored by the collider too
};

uint Bits(bool3 axes)
{
    return (axes.x ? 1 : 0) | (axes.y ? 2 : 0) | (axes.z ? 4 : 0);
}

bool3 Axes(uint bits)
{
    return bool3((bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0);
}

// enters: 1, or 0 for what is to add nothing
void Add(inout Sums sums, Particle particle, Mirror mirror, uint4 other, uint2 plane, float enters)
{
    float3 position = asfloat(other.xyz);
    Neighbor neighbor;
    neighbor.difference = (mirror.flips ? mirror.walls - position : position) - particle.position;
    neighbor.side = mirror.flips ? -1.0 : 1.0;
    neighbor.hasPlane = 1.0;
#ifdef WITH_COLLIDERS
    if (mirror.isInCollider)
    {
        // Beyond the plane lies water that stands beside the collider, not before it.
        float height = dot(neighbor.difference, particle.contact.xyz) + particle.contact.w;
        neighbor.difference -= 2.0 * height * particle.contact.xyz;
        neighbor.hasPlane = 0.0;
        enters = height > 0.0 ? enters : 0.0;
    }
#endif
    neighbor.displacement = other.w;
    neighbor.plane = plane;
    neighbor.enters = enters;
    neighbor.isImage = mirror.isImage;
    if (!mirror.isImage || dot(neighbor.difference, neighbor.difference) < kSupportSquared)
        AddNeighbor(sums, particle.own, neighbor);
}

void VisitList(inout Sums sums, Particle particle, Mirror mirror)
{
    uint i = particle.index;
    if (mirror.isImage && particle.lane == 0)       // the particle's own, which no list has
        Add(sums, particle, mirror, _Positions[i], PlaneOf(i), 1.0);
    uint base = NeighborBase(i);
    uint count = _NeighborCounts[i];
    uint first = 4 * particle.lane;
    uint4 next = NeighborBlock(i, base, first < count ? first : 0);
    for (uint k = first; k < count; k += 4 * kLanes)
    {
        // All loads of four neighbors are in flight before anything is done with it, and so is the list of the next four.
        uint4 block = next;
        next = NeighborBlock(i, base, k + 4 * kLanes < count ? k + 4 * kLanes : k);
        uint4 others[4];
        uint2 planes[4];
        uint e;
        [unroll]
        for (e = 0; e < 4; e++)
        {
            others[e] = _Positions[block[e]];
            planes[e] = PlaneOf(block[e]);
        }
        [unroll]
        for (e = 0; e < 4; e++)     // the last block of a list is filled up with the particle itself
            Add(sums, particle, mirror, others[e], planes[e], block[e] != i ? 1.0 : 0.0);
    }
}

#ifdef RILL_SLEEP
// Visits without a list; but nothing has moved since it was sorted, nor has anything near it.
void VisitRows(inout Sums sums, Particle particle, Mirror mirror)
{
    uint4 rows = RowsWithin(particle.position, kSupport);
    for (uint z = rows.y; z <= rows.w; z++)
    {
        for (uint y = rows.x; y <= rows.z; y++)
        {
            uint2 range = RowRange(particle.position, kSupportSquared, y, z);
            for (uint j = range.x + particle.lane; j < range.y; j += kLanes)
                Add(sums, particle, mirror, _Positions[j], PlaneOf(j), mirror.isImage || j != particle.index ? 1.0 : 0.0);
        }
    }
}
#endif

void Visit(inout Sums sums, Particle particle, Mirror mirror)
{
#ifdef RILL_SLEEP
    if (SleepsDeeply(particle.position))
    {
        VisitRows(sums, particle, mirror);
        return;
    }
#endif
    VisitList(sums, particle, mirror);
}

static const uint kCollider = 8;        // beside the bits of the axes

// An image for each combination of the axes with a wall near, and the collider. Few particles have one.
void VisitNeighbors(inout Sums sums, Particle particle)
{
    Mirror mirror;
    mirror.isImage = false;
    mirror.flips = false;
    mirror.walls = 0.0;
    mirror.isInCollider = false;
    Visit(sums, particle, mirror);

    float3 above = _DomainSize - particle.position;
    bool3 low = particle.position < kMirrorReach;
    bool3 high = above < kMirrorReach;
    bool3 isHigh = above < particle.position;
    uint near = Bits(low || high);
    uint both = Bits(low && high);
#ifdef WITH_COLLIDERS
    if (particle.contact.w < kMirrorReach)
    {
        // A wall behind the collider mirrors nothing.
        near &= ~Bits(abs(particle.contact.xyz) > kFacing && min(particle.position, above) >= particle.contact.w);
        near |= kCollider;
    }
#endif
    mirror.isImage = true;
    for (uint axes = near; axes != 0; axes = (axes - 1) & near)     // its subsets
    {
        mirror.flips = Axes(axes);
        mirror.isInCollider = (axes & kCollider) != 0;
        for (uint far = 0; far <= both; far++)      // once, but in a slice of water between two walls
        {
            if ((far & ~(axes & both)) != 0)
                continue;
            mirror.walls = (Axes(far) ? !isHigh : isHigh) ? 2.0 * _DomainSize : 0.0;
            Visit(sums, particle, mirror);
        }
    }
}

#endif
