// The kernels of probes and of the points of a batch, see Queries.compute.

// Each point has _GroupsPerLine groups, which search the line along gravity from where it leaves the box above.
[numthreads(kProbeGroup, 1, 1)]
void FindSurface(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    float3 p = _Points[group.x].xyz;
    float3 up = _Up.xyz;
    float2 range = RangeInBox(p, up);
    float lowest = range.x;
    TubeKind kind = TubesAlong(-up, kSamples);
    if (thread == 0)
        g_First = kNone;
    [loop]
    for (uint i = 0; i < _ChunksPerGroup; i++)
    {
        uint chunk = i * _GroupsPerLine + group.y;
        float top = range.y - chunk * kChunkLength;
        BeginChunk(thread, group.x, p + top * up);
        GroupMemoryBarrierWithGroupSync();
        bool isNeeded = g_First == kNone && top >= lowest && g_Found <= Sortable(top);
        if (isNeeded)
            ListPieces(kind, 0, thread, kProbeGroup);
        AddListed(thread, kind);
        float height = top - thread * kSampleStep;
        float density = 0.0;
        if (isNeeded && thread < kSamples)
        {
            density = DensityOf(thread, p + height * up);
            g_Densities[thread] = density;
            if (height >= lowest && density >= kHalfDensity)
                InterlockedMin(g_First, thread);
        }
        GroupMemoryBarrierWithGroupSync();
        // The first sample of a chunk is the last of the chunk above, which finds the surface there.
        if (isNeeded && thread == g_First && (thread > 0 || chunk == 0))
        {
            float above = g_Densities[max(thread, 1) - 1];
            float rest = thread == 0 ? 0.0 : (density - kHalfDensity) / max(density - above, 1e-6);     // water up to the lid: there
            InterlockedMax(_Found[group.x], Sortable(height + rest * kSampleStep));
        }
    }
}

// A group finds for each point the water around it and around its surface, and the slope of that.
[numthreads(kProbeGroup, 1, 1)]
void AnswerPoints(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint at = group.x * kProbeWords;
    uint found = _Found[group.x];
    bool hasSurface = found != 0;
    float3 p = _Points[group.x].xyz;
    float height = hasSurface ? FromSortable(found) : 0.0;
    float3 surface = p + height * _Up.xyz;
    if (thread < kPhases)
        g_Phases[thread] = 0;
    FindColumns(thread, hasSurface, surface, _Up.xyz);
    float4 around = SumThreads(thread, SumNear(thread, p, true));
    float4 aroundSurface = 0.0;
    if (hasSurface)
        aroundSurface = SumNear(thread, surface, false);
    aroundSurface = SumThreads(thread, aroundSurface);
    if (thread != 0)
        return;
    float3 normal = _Up.xyz;
    if (hasSurface)
        normal = NormalOfColumns(_Up.xyz, _Up.xyz);
    StoreFloat(at + kProbeDensity, _DensityScale * around.w / OpenPart(p));
    StoreVector(at + kProbeVelocity, around.xyz / max(around.w, 1e-9));
    _Results[at + kProbePhase] = DominantPhase();
    StoreFloat(at + kProbeHeight, height);
    StoreVector(at + kProbeNormal, normal);
    StoreVector(at + kProbeSurfaceVelocity, aroundSurface.xyz / max(aroundSurface.w, 1e-9));
    _Results[at + kProbeFlags] = (around.w > 0.0 ? kNearWater : 0) | (hasSurface ? kHasSurface : 0);
    _Found[group.x] = 0;
}
