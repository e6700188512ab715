// Which phases the water is of, for its mesh: WaterPhases.compute adds up the particles around the nodes of a coarse grid over the fluid's box. All
// in the frame of the mesh's field, d. Include after MeshField.hlsl and Generated/SurfaceView.hlsl.
//
//   _PhaseGrid     in  Texture3D, a texel for each node: particles of phases 1 to 3 around it, and of all
#ifndef RILL_PHASE_GRID_INCLUDED
#define RILL_PHASE_GRID_INCLUDED

Texture3D<float4> _PhaseGrid;
float4 _PhaseGridSize;          // xyz: nodes along each axis, of which the first lie in the walls; w: distance between them, d

static const float kMinPhaseSteps = 2.0, kMaxPhaseSteps = 16.0;     // along a stretch of a ray; between them, one for each node

// Returns the particles around a point: nearer nodes count more, and those without a particle do not count.
float4 PhasesAround(float3 p)
{
    return _PhaseGrid.SampleLevel(rill_field_linear_clamp_sampler, (p / _PhaseGridSize.w + 0.5) / _PhaseGridSize.xyz, 0);
}

// Fractions of phases 1 to 3, and of phase 0 in w.
float4 FractionsOf(float4 around)
{
    return float4(around.xyz, around.w - dot(around.xyz, 1.0)) / around.w;
}

// Returns the fractions of each phase and all that it mixes with.
float4 Together(float4 f)
{
    return float4(dot(_PhaseGroups[1], f), dot(_PhaseGroups[2], f), dot(_PhaseGroups[3], f), dot(_PhaseGroups[0], f));
}

// Returns the largest fraction that a phase does not mix with. group: its row.
float MaxOther(float4 group, float4 together)
{
    float4 others = together * (1.0 - group);
    return max(max(others.x, others.y), max(others.z, others.w));
}

// Returns how far each phase, with all that it mixes with, leads before the largest of the others, -1 to 1.
float4 Leads(float4 f)
{
    float4 together = Together(f);
    return together - float4(MaxOther(_PhaseGroups[1], together), MaxOther(_PhaseGroups[2], together),
        MaxOther(_PhaseGroups[3], together), MaxOther(_PhaseGroups[0], together));
}

// Returns the parts that are of each phase of a stretch along which fractions change evenly: where what it mixes with leads, its fraction of that.
float4 LeadingParts(float4 from, float4 to)
{
    float4 start = Leads(from), end = Leads(to), high = max(start, end);
    float4 shares = (from + to) / max(Together(from + to), 1e-6);
    float4 parts = saturate(high / max(high - min(start, end), 1e-6)) * shares;
    return parts / max(dot(parts, 1.0), 1e-6);
}

// Part of the light that a phase scatters, 1/m. parts: of phases 1 to 3; phase 0 is the rest.
float ScatteringOf(float3 parts)
{
    float3 others = float3(_PhaseScattering[1].w, _PhaseScattering[2].w, _PhaseScattering[3].w);
    return _PhaseScattering[0].w * saturate(1.0 - dot(parts, 1.0)) + dot(others, parts);
}

// Adds a straight stretch of a ray. sums: fractions of phases 1 to 3 times the length, and the length where they are known. Phases that do not
// mix have sharp borders: each point is of those that mix and have the most particles around it, and counts as far as one sees it.
void AddPhases(float3 from, float3 along, float reach, inout float4 sums)
{
    float steps = clamp(ceil(reach / _PhaseGridSize.w), kMinPhaseSteps, kMaxPhaseSteps), each = max(reach, 0.0) / steps;
    if (_HasPhases < 1.5)
    {
        [loop]
        for (float i = 0.5; i < steps; i += 1.0)
        {
            float4 around = PhasesAround(from + along * (i * each));
            if (around.w > 0.0)
                sums += each * float4(around.xyz / around.w, 1.0);
        }
        return;
    }
    float4 last = PhasesAround(from);
    float clear = 1.0;      // part of the light that what is nearer lets through: behind opaque grains nothing counts
    [loop]
    for (float k = 1.0; k <= steps; k += 1.0)
    {
        float4 next = PhasesAround(from + along * (k * each));
        if (last.w > 0.0 && next.w > 0.0)
        {
            float3 parts = LeadingParts(FractionsOf(last), FractionsOf(next)).xyz;
            float rate = ScatteringOf(parts) * Spacing(), through = exp(-rate * each);
            sums += clear * (rate * each > 1e-3 ? (1.0 - through) / rate : each) * float4(parts, 1.0);
            clear *= through;
        }
        last = next;
    }
}

// Returns the fractions of phases 1 to 3 along the stretches that were added.
float3 MeanPhases(float4 sums)
{
    return sums.xyz / max(sums.w, 1e-6);
}

// Returns the fractions of phases 1 to 3 along one straight stretch.
float3 PhasesAlong(float3 from, float3 along, float reach)
{
    float4 sums = 0.0;
    AddPhases(from, along, reach, sums);
    return MeanPhases(sums);
}

#endif
