// How walls hold a viscous fluid: by the water that is missing behind them, whose velocity along the wall goes on as it does
// between particle and wall. Include after Solver.hlsl; with WITH_COLLIDERS after ColliderBins.hlsl.
//
// A particle s from a plane wall of velocity u sees, y beyond it, fluid of velocity u - (v - u) y / s. So what is missing brakes it by
//   B(s) (u - v),  B(s) = 30 c / s  int_s^h y dy int w x^2 dA = c pi / 16 a^5 (a + 2 blend) / s,  a = h^2 - s^2,
// along the wall. Across it the pressure holds it.
#ifndef RILL_VISCOSITY_WALLS_INCLUDED
#define RILL_VISCOSITY_WALLS_INCLUDED

float _WallFriction;        // of the domain's walls: 0 slip, 1 no slip
float _WallHold;            // 1/d^2 of a^5 (a + 2 blend) / s, see LatticeKernels.ViscosityWallHold
float3 _WallMissing;        // of the same without 1 / s: sum w |x|^4, d^4, sum w |x|^2, d^2, and |sum w |x|^2 x|, d^3, that are missing behind a wall

// The strongest of the walls near a particle, one for each direction.
struct Walls
{
    float3 normals[3];
    float3 velocities[3];   // d/s
    float3 shapes;          // a^5 (a + 2 blend) times the friction; 0: none
    float3 distances;       // d
};

float WallShape(float distance)
{
    float a = max(kSupportSquared - distance * distance, 0.0);
    float square = a * a;
    return square * square * a * (a + 2.0 * _Blend);
}

Walls DomainWalls(float3 p)
{
    Walls walls = (Walls)0;
    float3 above = _DomainSize - p;
    walls.distances = max(min(p, above), kContactOffset);
    [unroll]
    for (uint axis = 0; axis < 3; axis++)
    {
        walls.normals[axis][axis] = p[axis] < above[axis] ? 1.0 : -1.0;
        walls.shapes[axis] = _WallFriction * WallShape(walls.distances[axis]);
    }
    return walls;
}

#ifdef WITH_COLLIDERS

// Walls with the same normal are one.
void AddWall(inout Walls walls, float3 normal, float3 velocity, float friction, float distance)
{
    distance = max(distance, kContactOffset);
    float shape = friction * WallShape(distance);
    float weakest = min(walls.shapes.x, min(walls.shapes.y, walls.shapes.z));
    uint slot = walls.shapes.x == weakest ? 0 : walls.shapes.y == weakest ? 1 : 2;
    [unroll]
    for (uint i = 0; i < 3; i++)
        slot = dot(walls.normals[i], normal) >= kSameSurfaceCosine ? i : slot;
    [unroll]
    for (uint k = 0; k < 3; k++)
    {
        bool stronger = k == slot && shape > walls.shapes[k];
        walls.normals[k] = stronger ? normal : walls.normals[k];
        walls.velocities[k] = stronger ? velocity : walls.velocities[k];
        walls.shapes[k] = stronger ? shape : walls.shapes[k];
        walls.distances[k] = stronger ? distance : walls.distances[k];
    }
}

void AddColliders(inout Walls walls, float3 p)
{
    uint cell = ColliderCell(p);
    FOR_COLLIDERS(cell, index)
        Collider collider = _Colliders[index];
        float4 contact = DomainDistance(collider, p);
        if (contact.w < kSupport)
            AddWall(walls, contact.xyz, SurfaceMotion(collider, p) * _InverseTimeStep, collider.friction, contact.w);
    END_COLLIDERS
}

#endif

// Effect of walls on a particle: its acceleration is 15 nu / d^2 (pull - hold v), the hold a symmetric matrix.
struct WallHold
{
    float3 diagonal;        // 1/d^2: xx, yy, zz
    float3 others;          // yz, zx, xy
    float3 pull;            // 1/(d s)
    float shape;            // of all walls
    float3 lean;            // of all, along their normals
};

// Its velocity is counted without what gravity adds in the substep, which acts before the wall does.
WallHold HoldOf(Walls walls)
{
    WallHold result = (WallHold)0;
    [unroll]
    for (uint k = 0; k < 3; k++)
    {
        float3 normal = walls.normals[k];
        float hold = _WallHold * walls.shapes[k] / walls.distances[k];
        float3 velocity = walls.velocities[k] - _GravityStep * _InverseTimeStep;
        result.diagonal += hold * (1.0 - normal * normal);
        result.others -= hold * normal.yzx * normal.zxy;
        result.pull += hold * (velocity - normal * dot(normal, velocity));
        result.shape += walls.shapes[k];
        result.lean += walls.shapes[k] * normal;
    }
    return result;
}

float3 ApplyHold(float3 diagonal, float3 others, float3 v)
{
    return diagonal * v + others.zxy * v.yzx + others.yzx * v.zxy;
}

#endif
