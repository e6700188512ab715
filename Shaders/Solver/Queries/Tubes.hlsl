// Particles around lines, found by a group of threads: those within the kernel's support of a line's part, and what they add to the density
// at samples along it. Include after WaterAround.hlsl.
//
// Each step shares its work out evenly over the threads, however the particles lie: the rows of cells that tubes touch are cut into pieces of
// a few particles, the pieces are searched for particles in the tubes, and what these add to the samples is summed.
#ifndef RILL_TUBES_INCLUDED
#define RILL_TUBES_INCLUDED

static const float kSampleStep = 0.5;           // of the density along a line, d
static const float kColumnScale = 1048576.0;    // steps of a density
static const uint kMaxTubes = 16;
static const uint kMaxSamples = 240;            // of all tubes of a group
static const float kTubeReach = kSupport + kReachMargin;

static const uint kPiece = 4;                   // particles, in flight at once
static const uint kPieceCapacity = 1024;        // more are searched where they are met
static const uint kListCapacity = 1024;         // particles in tubes; what more of them add is summed where they are met
static const uint kTubeBits = 4;
static const uint kCountBits = 2;               // which leaves 26 for a particle: SolverLayout.MaxCapacity takes 24

groupshared float3 g_TubeStarts[kMaxTubes];     // where the first sample of each is, d
groupshared uint g_PieceCount;
groupshared uint g_Pieces[kPieceCapacity];      // first particle, tube, number of particles - 1
groupshared uint g_ListCount;
groupshared uint g_List[kListCapacity];         // particle, tube
groupshared uint g_Samples[kMaxSamples];        // density without its scale, of each tube's samples in turn

// Values that tubes of one kind have in common.
struct TubeKind
{
    float3 direction;   // length 1
    float begin, end;   // of what counts along the line, from its first sample on, d
    uint samples;       // of each
};

TubeKind TubesAlong(float3 direction, uint samples)
{
    TubeKind kind;
    kind.direction = direction;
    kind.begin = -kSupport;
    kind.end = (samples - 1) * kSampleStep + kSupport;
    kind.samples = samples;
    return kind;
}

// Adds a particle to the samples of a tube. Sums are integers: their order does not matter.
void AddToSamples(uint tube, uint samples, float along, float asideSquared)
{
    int first = max(int(ceil((along - kSupport) / kSampleStep)), 0);
    int last = min(int(floor((along + kSupport) / kSampleStep)), int(samples) - 1);
    for (int k = first; k <= last; k++)
    {
        float between = k * kSampleStep - along;
        InterlockedAdd(g_Samples[tube * samples + k], uint(_DensityScale * Poly6(asideSquared + between * between) * kColumnScale));
    }
}

// Position of a particle in a tube: x along it from its first sample, d, y squared distance from its line, d^2.
float2 InTube(TubeKind kind, uint tube, float3 particle)
{
    float3 away = particle - g_TubeStarts[tube];
    float along = dot(away, kind.direction);
    return float2(along, dot(away, away) - along * along);
}

// Lists those of a piece's particles that lie in its tube.
void SearchPiece(TubeKind kind, uint piece)
{
    uint count = (piece & ((1u << kCountBits) - 1)) + 1;
    uint tube = piece >> kCountBits & (kMaxTubes - 1);
    uint first = piece >> (kCountBits + kTubeBits);
    float3 particles[kPiece];
    [unroll]
    for (uint load = 0; load < kPiece; load++)
        particles[load] = PositionOf(first + min(load, count - 1));
    uint hits = 0;
    [unroll]
    for (uint k = 0; k < kPiece; k++)
    {
        float2 at = InTube(kind, tube, particles[k]);
        hits |= k < count && at.y < kSupportSquared && at.x >= kind.begin && at.x < kind.end ? 1u << k : 0;
    }
    if (hits == 0)
        return;
    uint slot;
    InterlockedAdd(g_ListCount, countbits(hits), slot);
    [loop]
    for (; hits != 0; hits &= hits - 1)
    {
        uint particle = first + firstbitlow(hits);
        if (slot < kListCapacity)
            g_List[slot] = particle << kTubeBits | tube;
        else
        {
            float2 at = InTube(kind, tube, PositionOf(particle));
            AddToSamples(tube, kind.samples, at.x, at.y);
        }
        slot++;
    }
}

uint PieceOf(uint first, uint count, uint tube)
{
    return (first << kTubeBits | tube) << kCountBits | (count - 1);
}

// Sorted particles of the row (y, z) of cells that a tube may have particles in: 'from' one end of its line to 'along' from there, and at
// most 'aside' from it along each axis.
uint2 TubeRange(float3 from, float3 along, float3 aside, uint y, uint z)
{
    // The part of the line, of 1, that is near enough along y and z.
    float2 low = float2(y, z) * _CellSize.yz, high = low + _CellSize.yz;
    float2 slant = abs(along.yz) > 1e-6 ? along.yz : 1e-6;
    float2 enters = (low - aside.yz - from.yz) / slant, leaves = (high + aside.yz - from.yz) / slant;
    float2 begins = min(enters, leaves), ends = max(enters, leaves);
    float begin = max(max(begins.x, begins.y), 0.0), end = min(min(ends.x, ends.y), 1.0);
    if (begin > end)
        return 0;
    float3 p = from + begin * along, q = from + end * along;
    float3 lowest = min(p, q), highest = max(p, q);
    float2 gap = max(max(low - highest.yz, lowest.yz - high), 0.0);
    float left = kTubeReach * kTubeReach - dot(gap, gap);
    if (left <= 0.0)
        return 0;
    float reach = min(sqrt(left), aside.x);
    return RowPart(lowest.x - reach, highest.x + reach, y, z);
}

// Cuts what the rows of cells around a tube hold into pieces, by 'lanes' threads of which this is one.
void ListPieces(TubeKind kind, uint tube, uint lane, uint lanes)
{
    float3 from = g_TubeStarts[tube] + (kind.begin - kReachMargin) * kind.direction;
    float3 along = (kind.end - kind.begin + 2.0 * kReachMargin) * kind.direction;
    float3 aside = kTubeReach * sqrt(saturate(1.0 - kind.direction * kind.direction));
    float2 lowest = min(from.yz, from.yz + along.yz) - aside.yz, highest = max(from.yz, from.yz + along.yz) + aside.yz;
    uint2 last = _CellCounts.yz - 1;
    uint2 low = min(uint2(max(lowest * _InverseCellSize.yz, 0.0)), last);
    uint2 counts = min(uint2(max(highest * _InverseCellSize.yz, 0.0)), last) - low + 1;
    uint rows = _IsSorted != 0 ? counts.x * counts.y : 0;
    uint unsorted = FirstUnsorted(), alive = _Counters[kAlive], part = (alive - unsorted + lanes - 1) / lanes;
    for (uint row = lane; row < rows + lanes; row += lanes)
    {
        uint2 range = min(unsorted + part * uint2(lane, lane + 1), alive);      // after the rows its part of what is in none
        if (row < rows)
            range = TubeRange(from, along, aside, low.x + row % counts.x, low.y + row / counts.x);
        uint slot = 0;
        if (range.x < range.y)
            InterlockedAdd(g_PieceCount, (range.y - range.x + kPiece - 1) / kPiece, slot);
        for (uint i = range.x; i < range.y; i += kPiece)
        {
            uint piece = PieceOf(i, min(range.y - i, kPiece), tube);
            if (slot < kPieceCapacity)
                g_Pieces[slot] = piece;
            else
                SearchPiece(kind, piece);
            slot++;
        }
    }
}

// By one thread, before a barrier.
void ClearLists()
{
    g_PieceCount = 0;
    g_ListCount = 0;
}

// Adds what was listed to the samples. All threads come here.
void AddListed(uint thread, TubeKind kind)
{
    GroupMemoryBarrierWithGroupSync();
    uint pieces = min(g_PieceCount, kPieceCapacity);
    for (uint piece = thread; piece < pieces; piece += kProbeGroup)
        SearchPiece(kind, g_Pieces[piece]);
    GroupMemoryBarrierWithGroupSync();
    uint listed = min(g_ListCount, kListCapacity);
    for (uint i = thread; i < listed; i += kProbeGroup)
    {
        uint tube = g_List[i] & (kMaxTubes - 1);
        float2 at = InTube(kind, tube, PositionOf(g_List[i] >> kTubeBits));
        AddToSamples(tube, kind.samples, at.x, at.y);
    }
    GroupMemoryBarrierWithGroupSync();
}

#endif
