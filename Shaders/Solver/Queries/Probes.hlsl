// The kernels of probes and of the points of a batch, see Queries.compute.

groupshared uint g_Found;

// A chunk of the line along gravity, which begins where the line leaves the box above.
[numthreads(kProbeGroup, 1, 1)]
void FindSurface(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    float3 p = _Points[group.x].xyz;
    float3 up = _Up.xyz;
    float2 range = RangeInBox(p, up);
    float lowest = range.x;
    float top = range.y - group.y * kChunkLength;

    uint k = min(thread, kSamples - 1);
    if (thread == 0)
    {
        g_First = kNone;
        g_ListCount = 0;
        g_Found = _Results[group.x * kProbeWords + kProbeHeight];       // what chunks above have found so far
    }
    if (thread < kSamples)
        g_Column[thread] = 0;
    GroupMemoryBarrierWithGroupSync();
    if (top >= lowest && g_Found <= Sortable(top))
        AddChunk(thread, p + top * up, -up);
    AddListed(thread, false);
    float height = top - k * kSampleStep;
    float density = DensityOf(k, p + height * up);
    if (thread < kSamples)
        g_Densities[thread] = density;
    if (height >= lowest && density >= kHalfDensity)
        InterlockedMin(g_First, k);
    GroupMemoryBarrierWithGroupSync();
    // The first sample of a chunk is the last of the chunk above, which finds the surface there.
    if (thread == g_First && (thread > 0 || group.y == 0))
    {
        float above = g_Densities[max(thread, 1) - 1];
        float rest = thread == 0 ? 0.0 : (density - kHalfDensity) / max(density - above, 1e-6);     // water up to the lid: there
        InterlockedMax(_Results[group.x * kProbeWords + kProbeHeight], Sortable(height + rest * kSampleStep));
    }
}

// Of each probe kColumnGroups groups of columns, the water around its surface, and that around itself.
[numthreads(kProbeGroup, 1, 1)]
void FindSurroundings(uint3 group : SV_GroupID, uint thread : SV_GroupIndex)
{
    uint at = group.x * kProbeWords;
    uint found = _Results[at + kProbeHeight];
    bool ofColumns = group.y < kColumnGroups;
    bool ofProbe = group.y > kColumnGroups;
    bool isAsked = ofProbe || found != 0;
    float3 p = _Points[group.x].xyz;
    float3 center = ofProbe ? p : p + FromSortable(found) * _Up.xyz;
    if (thread < kPhases)
        g_Phases[thread] = 0;
    if (thread < kGroupColumns * kRingSamples)
        g_Ring[thread] = 0;
    if (thread == 0)
        g_ListCount = 0;
    GroupMemoryBarrierWithGroupSync();

    float4 near = 0.0;
    if (isAsked && ofColumns)
        AddRings(thread, group.y * kGroupColumns, center, _Up.xyz);
    else if (isAsked)
        near = SumNear(thread, center, ofProbe);
    AddListed(thread, true);
    SetValues(thread, 0, near.xyz);
    SetValue(thread, 3, near.w);
    SumValues(thread, 4);
    float height = FindRingHeight(thread, ofColumns && isAsked, group.y * kGroupColumns, center, _Up.xyz);
    if (ofColumns && thread < kGroupColumns)
        _RingHeights[group.x * kColumns + group.y * kGroupColumns + thread] = height;
    if (thread != 0 || ofColumns)
        return;
    float3 velocity = Sum3(0) / max(g_Sums[3], 1e-9);
    if (!ofProbe)
    {
        StoreVector(at + kProbeSurfaceVelocity, velocity);
        return;
    }
    StoreFloat(at + kProbeDensity, _DensityScale * g_Sums[3] / OpenPart(p));
    StoreVector(at + kProbeVelocity, velocity);
    _Results[at + kProbePhase] = DominantPhase();
    _Results[at + kProbeFlags] = (g_Sums[3] > 0.0 ? kNearWater : 0) | (found != 0 ? kHasSurface : 0);
}

// A group for each probe, a thread for each of its columns.
[numthreads(kColumns, 1, 1)]
void FitNormal(uint3 group : SV_GroupID, uint column : SV_GroupIndex)
{
    uint at = group.x * kProbeWords;
    uint found = _Results[at + kProbeHeight];
    float height = found != 0 ? FromSortable(found) : 0.0;
    float3 center = _Points[group.x].xyz + height * _Up.xyz;
    g_Columns[column] = float3(RingOffset(column, center, _Up.xyz), _RingHeights[group.x * kColumns + column]);
    GroupMemoryBarrierWithGroupSync();
    if (column != 0)
        return;
    float3 normal = _Up.xyz;
    if (found != 0)
        normal = NormalOfRing(_Up.xyz, _Up.xyz);
    StoreFloat(at + kProbeHeight, height);
    StoreVector(at + kProbeNormal, normal);
}
