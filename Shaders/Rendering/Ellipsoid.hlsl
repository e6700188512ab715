// Ellipsoids and the rays that hit them.
#ifndef RILL_ELLIPSOID_INCLUDED
#define RILL_ELLIPSOID_INCLUDED

struct Ellipsoid
{
    float3 center;      // world
    float3 a, b, c;     // semi-axes, world, at right angles to each other
};

// A vector in the frame in which the ellipsoid is a ball of radius 1.
float3 ToBall(Ellipsoid e, float3 v)
{
    float3 squares = float3(dot(e.a, e.a), dot(e.b, e.b), dot(e.c, e.c));
    return float3(dot(e.a, v), dot(e.b, v), dot(e.c, v)) / max(squares, 1e-20);
}

// Returns where the ray enters the ball of radius 1 and where it leaves it; false if it misses.
bool HitBall(float3 origin, float3 direction, out float2 hit)
{
    float squared = max(dot(direction, direction), 1e-20);
    float nearestT = -dot(origin, direction) / squared;
    float3 nearest = origin + direction * nearestT;       // and not b b - a c, which cancels far away
    float missing = 1.0 - dot(nearest, nearest);
    float halfWay = sqrt(max(missing, 0.0) / squared);
    hit = float2(nearestT - halfWay, nearestT + halfWay);
    return missing > 0.0;
}

// Unit normal, out of the ellipsoid, at a point of its surface.
float3 EllipsoidNormal(Ellipsoid e, float3 world)
{
    float3 inBall = ToBall(e, world - e.center);
    float3 normal = e.a * (inBall.x / max(dot(e.a, e.a), 1e-20)) + e.b * (inBall.y / max(dot(e.b, e.b), 1e-20))
        + e.c * (inBall.z / max(dot(e.c, e.c), 1e-20));
    return normal * rsqrt(max(dot(normal, normal), 1e-20));
}

#endif
