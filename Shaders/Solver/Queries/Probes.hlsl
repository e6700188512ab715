// The kernel of probes and of the points of a batch, see Queries.compute.

groupshared float g_Height;         // of the surface over the point, d
groupshared uint g_HasSurface;

// Finds the highest surface on the line along gravity through a point: downwards in chunks, from where the line leaves the box above. All
// threads come here.
void FindSurface(uint thread, float3 p)
{
    float3 up = _Up.xyz;
    float2 range = RangeInBox(p, up);
    if (thread == 0)
    {
        g_HasSurface = 0;
        g_Height = 0.0;
    }
    uint k = min(thread, kSamples - 1);
    for (uint first = 0; first < _Chunks; first += kMarked)
    {
        if (thread == 0)
            g_Chunks = 0;
        GroupMemoryBarrierWithGroupSync();
        if (g_HasSurface == 0)
            MarkChunks(thread, p + (range.y - first * kChunkLength) * up, -up);
        GroupMemoryBarrierWithGroupSync();
        uint rounds = min(_Chunks - first, kMarked);
        for (uint round = 0; round < rounds; round++)
        {
            uint left = g_Chunks;
            uint chunk = first + firstbitlow(left);
            float top = range.y - chunk * kChunkLength;
            bool isNeeded = left != 0 && g_HasSurface == 0 && top >= range.x;
            ClearSamples(thread);
            if (thread == 0)
                g_First = kNone;
            GroupMemoryBarrierWithGroupSync();
            if (thread == 0)
                g_Chunks = left & (left - 1);
            if (isNeeded)
                AddChunk(thread, p + top * up, -up);
            AddListed(thread, false);
            float height = top - k * kSampleStep;
            float density = 0.0;
            if (isNeeded && thread < kSamples)
            {
                density = DensityOf(k, p + height * up);
                g_Densities[k] = density;
                if (height >= range.x && density >= kHalfDensity)
                    InterlockedMin(g_First, k);
            }
            GroupMemoryBarrierWithGroupSync();
            // The first sample of a chunk is the last of the chunk above, which finds the surface there.
            if (isNeeded && thread == g_First && (thread > 0 || chunk == 0))
            {
                float above = g_Densities[max(k, 1) - 1];
                float rest = k == 0 ? 0.0 : (density - kHalfDensity) / max(density - above, 1e-6);      // water up to the lid: there
                g_Height = height + rest * kSampleStep;
                g_HasSurface = 1;
            }
            GroupMemoryBarrierWithGroupSync();
        }
    }
    GroupMemoryBarrierWithGroupSync();
}

// Sums the water around p over the group's threads: xyz of the result velocity, w density without its scale. All threads come here.
float4 SumAround(uint thread, float3 p, bool isAsked, bool ofPhases)
{
    float4 near = 0.0;
    if (isAsked)
        near = SumNear(thread, p, ofPhases);
    SetValues(thread, 0, near.xyz);
    SetValue(thread, 3, near.w);
    SumValues(thread, 4);
    return float4(Sum3(0) / max(g_Sums[3], 1e-9), g_Sums[3]);
}

// A group for each point: the water around it, the surface over it, and the water and the slope there.
[numthreads(kProbeGroup, 1, 1)]
void AnswerPoints(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    float3 p = _Points[group.x].xyz;
    if (thread < kPhases)
        g_Phases[thread] = 0;
    FindSurface(thread, p);
    bool hasSurface = g_HasSurface != 0;
    float3 surface = p + g_Height * _Up.xyz;
    float4 around = SumAround(thread, p, true, true);
    float3 surfaceVelocity = SumAround(thread, surface, hasSurface, false).xyz;
    FindColumns(thread, hasSurface, surface, _Up.xyz);
    if (thread != 0)
        return;
    float3 normal = _Up.xyz;
    if (hasSurface)
        normal = NormalOfRing(_Up.xyz, _Up.xyz);
    uint at = group.x * kProbeWords;
    StoreFloat(at + kProbeDensity, _DensityScale * around.w / OpenPart(p));
    StoreVector(at + kProbeVelocity, around.xyz);
    _Results[at + kProbePhase] = DominantPhase();
    StoreFloat(at + kProbeHeight, g_Height);
    StoreVector(at + kProbeNormal, normal);
    StoreVector(at + kProbeSurfaceVelocity, surfaceVelocity);
    _Results[at + kProbeFlags] = (around.w > 0.0 ? kNearWater : 0) | (hasSurface ? kHasSurface : 0);
}
