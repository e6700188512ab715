// The density constraint at one particle, for kernels that correct positions in place; as in the package's
// DensityConstraint.compute, but for what pairs nearer than 0.25 d get there beside: it is not what is compared.
// Include after Solver.hlsl and NeighborList.hlsl.
#ifndef STUDY_CONSTRAINT_INCLUDED
#define STUDY_CONSTRAINT_INCLUDED

RWStructuredBuffer<float4> _Positions;      // [kSorted], xyz position, d; w the multiplier lambda
StructuredBuffer<uint> _NeighborCounts;     // [kSorted]

uint Neighbor(uint i, uint base, uint k)
{
    return NeighborBlock(i, base, k & ~3u)[k & 3];
}

// Gradient of the spiky kernel along a pair, without its normalization.
float3 SpikyGradient(float3 difference)
{
    float inverse = rsqrt(max(dot(difference, difference), kCoincident));
    float t = max(kSupport - dot(difference, difference) * inverse, 0.0);
    return difference * (t * t * inverse);
}

// lambda_i = -C_i / (sum_k |grad_k C_i|^2 + epsilon), and the gradient with respect to the particle itself.
float SolveMultiplier(uint i, float3 p, uint base, uint count, out float3 gradient, out float3 wallGradient)
{
    float density = 0.0;
    float squares = 0.0;
    gradient = 0.0;
    for (uint k = 0; k < count; k++)
    {
        float3 difference = p - _Positions[Neighbor(i, base, k)].xyz;
        float3 pair = SpikyGradient(difference);
        density += Poly6(dot(difference, difference));
        gradient += pair;
        squares += dot(pair, pair);
    }
    float wall;
    WallDensity(p, wall, wallGradient);
    gradient = _GradientScale * gradient + wallGradient;
    squares = _GradientScale * _GradientScale * squares + dot(gradient, gradient);
    float error = _DensityScale * density + _SelfDensity + wall - 1.0;
    return -max(error, -_AllowedTension) / (squares + _Epsilon);
}

float3 Limited(float3 correction)
{
    float lengthSquared = dot(correction, correction);
    return lengthSquared > _MaxCorrection * _MaxCorrection ? correction * (_MaxCorrection * rsqrt(lengthSquared)) : correction;
}

#endif
