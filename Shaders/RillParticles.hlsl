// The particles of a FluidSimulation for shaders of a project, in world space: FluidParticles.Bind sets all that this file declares.
// It includes nothing but its constants, and works in compute shaders and in the stages of a draw.
//
//   #include "Packages/com.rill.fluids/Shaders/RillParticles.hlsl"
//
// Define RILL_WRITE_PARTICLES before it in a compute shader that changes velocities or phases or removes particles, in a pass of
// FluidSimulation.BeforeStep. Such a kernel takes two of the eight read-write resources of Direct3D 11.
//
//   _RillPositions      [count]      in   float4, xyz position, d, in the frame of the box, whose lowest corner is 0
//   _RillStartPositions [moved]      in   float4, xyz position at the start of the last substep, d; of the particles that took part in it
//   _RillVelocities     [count]      i/o  float4, xyz velocity, d/s, in the frame of the box; w density relative to rest where it is summed,
//                                         else 1, below 0 where the particle is removed in this step
//   _RillTags           [count]      i/o  uint, phase and end of life; where there are phases, see RillHasPhases
//   _RillIds            [count]      in   uint, never given twice until the fluid starts again
//   _RillCounters                    in   uint, see Generated/RillParticles.hlsl
//   _RillCellStarts     [cells + 1]  in   uint, particles in all cells before, as FluidParticles.SortNeighbors left them
//   _RillOrder          [count]      in   uint, index of a particle, by cell
#ifndef RILL_PARTICLES_INCLUDED
#define RILL_PARTICLES_INCLUDED

#include "Generated/RillParticles.hlsl"

StructuredBuffer<float4> _RillPositions;
StructuredBuffer<float4> _RillStartPositions;
StructuredBuffer<uint> _RillIds;
StructuredBuffer<uint> _RillCounters;
StructuredBuffer<uint> _RillCellStarts;
StructuredBuffer<uint> _RillOrder;
#ifdef RILL_WRITE_PARTICLES
RWStructuredBuffer<float4> _RillVelocities;
RWStructuredBuffer<uint> _RillTags;
#else
StructuredBuffer<float4> _RillVelocities;
StructuredBuffer<uint> _RillTags;
#endif

float4x4 _RillDomainToWorld;    // from the box's frame in d to world, m
float4 _RillDomain;             // xyz size of the box, d; w the spacing d, m
float4 _RillCells;              // xyz cells along each side; w 1 where particles have phases
float4 _RillInverseCellSize;    // xyz 1/d
// x length of a fixed step, s; y that of it which an acceleration acts at once, s; z, w the frame's time after the state, in substeps and s
float4 _RillStep;

// Which particle a thread of FluidParticles.Dispatch is for: [numthreads(kRillThreads, 1, 1)], SV_GroupID and SV_GroupIndex. Leave the
// kernel where it is not below RillCount().
uint RillIndex(uint3 group, uint thread)
{
    return (group.y * kRillMaxGroups + group.x) * kRillThreads + thread;
}

// Particles alive: they are the first of each buffer.
uint RillCount()
{
    return _RillCounters[kRillAlive];
}

// Distance between particles at rest, m.
float RillSpacing()
{
    return _RillDomain.w;
}

// From the box's frame in d to world, m.
float3 RillToWorld(float3 position)
{
    return mul(_RillDomainToWorld, float4(position, 1.0)).xyz;
}

// From world, m, to the box's frame in d.
float3 RillToDomain(float3 world)
{
    float3 origin = float3(_RillDomainToWorld[0].w, _RillDomainToWorld[1].w, _RillDomainToWorld[2].w);
    return mul(world - origin, (float3x3)_RillDomainToWorld) / (_RillDomain.w * _RillDomain.w);
}

// Converts a velocity, m/s; that of the box itself is not in it.
float3 RillVelocityToWorld(float3 velocity)
{
    return mul((float3x3)_RillDomainToWorld, velocity);
}

float3 RillVelocityToDomain(float3 world)
{
    return mul(world, (float3x3)_RillDomainToWorld) / (_RillDomain.w * _RillDomain.w);
}

// World, m.
float3 RillPosition(uint i)
{
    return RillToWorld(_RillPositions[i].xyz);
}

// World, m, at the time of the frame, which lies between fixed steps: where the package's own renderers draw the particle.
float3 RillDrawnPosition(uint i)
{
    float3 position = _RillPositions[i].xyz;
    float3 path = i < _RillCounters[kRillMoved] ? (position - _RillStartPositions[i].xyz) * _RillStep.z : _RillVelocities[i].xyz * _RillStep.w;
    return RillToWorld(clamp(position + path, min(position, 0.5), max(position, _RillDomain.xyz - 0.5)));
}

// World, m/s, against the box.
float3 RillVelocity(uint i)
{
    return RillVelocityToWorld(_RillVelocities[i].xyz);
}

uint RillId(uint i)
{
    return _RillIds[i];
}

// Whether particles have phases: an emitter gives some, or FluidSimulation.TrackPhases is on.
bool RillHasPhases()
{
    return _RillCells.w > 0.5;
}

// 0 to 255; 0 where there are none.
uint RillPhase(uint i)
{
    uint phase = 0;
    if (RillHasPhases())
        phase = _RillTags[i] >> kRillPhaseShift;
    return phase;
}

// Particles nearer than a radius to a point, in cell by cell order, the same on every run. Record FluidParticles.SortNeighbors first.
//
//   RillNeighbors neighbors = RillFindNeighbors(RillPosition(i), 2.0 * RillSpacing());
//   uint j;
//   while (RillNext(neighbors, j))
//       if (j != i) ...
struct RillNeighbors
{
    float3 center;          // d
    float radiusSquared;    // d^2
    uint3 low;              // cells
    uint3 high;             // the last, inclusive
    uint2 row;              // y, z of the next
    uint2 range;            // of the order
};

// world, radius: m. The time taken grows with the particles in the cells that the ball touches.
RillNeighbors RillFindNeighbors(float3 world, float radius)
{
    RillNeighbors neighbors;
    neighbors.center = RillToDomain(world);
    float reach = radius / _RillDomain.w;
    neighbors.radiusSquared = reach * reach;
    float3 last = _RillCells.xyz - 1.0;
    neighbors.low = uint3(clamp(floor((neighbors.center - reach) * _RillInverseCellSize.xyz), 0.0, last));
    neighbors.high = uint3(clamp(floor((neighbors.center + reach) * _RillInverseCellSize.xyz), 0.0, last));
    neighbors.row = neighbors.low.yz;
    neighbors.range = 0;
    return neighbors;
}

// The next of them; false where there is none left.
bool RillNext(inout RillNeighbors neighbors, out uint particle)
{
    uint3 cells = uint3(_RillCells.xyz);
    particle = 0;
    bool found = false;
    bool ended = false;
    [loop]
    while (!found && !ended)
    {
        if (neighbors.range.x < neighbors.range.y)
        {
            particle = _RillOrder[neighbors.range.x];
            neighbors.range.x++;
            float3 away = _RillPositions[particle].xyz - neighbors.center;
            found = dot(away, away) < neighbors.radiusSquared;
        }
        else if (neighbors.row.y > neighbors.high.z)
        {
            ended = true;
        }
        else
        {
            uint first = (neighbors.row.y * cells.y + neighbors.row.x) * cells.x;
            neighbors.range = uint2(_RillCellStarts[first + neighbors.low.x], _RillCellStarts[first + neighbors.high.x + 1]);
            bool isLast = neighbors.row.x == neighbors.high.y;
            neighbors.row = isLast ? uint2(neighbors.low.y, neighbors.row.y + 1) : uint2(neighbors.row.x + 1, neighbors.row.y);
        }
    }
    return found;
}

#ifdef RILL_WRITE_PARTICLES

// World, m/s, against the box. Of a velocity that is not finite the particle is removed and counted as such.
void RillSetVelocity(uint i, float3 velocity)
{
    _RillVelocities[i] = float4(RillVelocityToDomain(velocity), _RillVelocities[i].w);
}

// An acceleration over this step, world, m/s^2: as a force field gives it, also where Numerical Damping is below 1.
void RillAccelerate(uint i, float3 acceleration)
{
    float4 velocity = _RillVelocities[i];
    _RillVelocities[i] = float4(velocity.xyz + RillVelocityToDomain(acceleration) * _RillStep.y, velocity.w);
}

// Sets a phase, 0 to 255; does nothing without phases.
void RillSetPhase(uint i, uint phase)
{
    if (RillHasPhases())
        _RillTags[i] = (_RillTags[i] & kRillTagStepMask) | (min(phase, 255u) << kRillPhaseShift);
}

// Removes the particle in this step. It is counted among those that drains remove.
void RillKill(uint i)
{
    _RillVelocities[i] = float4(_RillVelocities[i].xyz, kRillKilled);
}

#endif

#endif
