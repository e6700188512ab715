// The medium that light goes through in the water: by its look, or by those of its phases. Include after SurfaceView.hlsl, and
// where RILL_PHASES is on after PhaseGrid.hlsl.
#ifndef RILL_MEDIUM_INCLUDED
#define RILL_MEDIUM_INCLUDED

#include "../Generated/PhaseGrid.hlsl"

struct Medium
{
    float3 absorption;      // 1/m
    float3 color;           // that is scattered, linear
    float scattering;       // 1/m
};

Medium MediumOfLook()
{
    Medium m;
    m.absorption = _Absorption.rgb;
    m.color = _Scattering.rgb;
    m.scattering = _Scattering.w;
    return m;
}

// Returns the mean of the phases along a ray, as if they were stirred: exact for what is absorbed. amounts: of each phase, not all 0.
Medium Stirred(float4 amounts)
{
    float3 absorbed = 0.0, scattered = 0.0;
    float rate = 0.0, total = dot(amounts, 1.0);
    for (uint i = 0; i < kMaxPhases; i++)
    {
        absorbed += _PhaseAbsorption[i].rgb * amounts[i];
        scattered += _PhaseScattering[i].rgb * (_PhaseScattering[i].w * amounts[i]);
        rate += _PhaseScattering[i].w * amounts[i];
    }
    Medium m;
    m.absorption = absorbed / total;
    m.color = scattered / max(rate, 1e-9);
    m.scattering = rate / total;
    return m;
}

// fractions: of phases 1 to 3; phase 0 is the rest.
Medium Stirred(float3 fractions)
{
    return Stirred(float4(max(1.0 - dot(fractions, 1.0), 0.0), fractions));
}

// Returns the medium along a straight path from a point of the domain, both in d, in the frame of the mesh's field.
Medium MediumAlong(float3 from, float3 along, float path)
{
    Medium medium = MediumOfLook();
#ifdef RILL_PHASES
    if (_HasPhases > 0.5)
        medium = Stirred(PhasesAlong(from, along, path));
#endif
    return medium;
}

#endif
