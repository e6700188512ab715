// Quads that face the eye, two triangles each, and hold a ball. Needs View.hlsl; includes nothing.
#ifndef RILL_BILLBOARD_INCLUDED
#define RILL_BILLBOARD_INCLUDED

// Returns the corner of one of the six vertices: -1 to 1.
float2 QuadCorner(uint vertex)
{
    static const float2 kCorners[6] = { float2(-1, -1), float2(-1, 1), float2(1, 1), float2(-1, -1), float2(1, 1), float2(1, -1) };
    return kCorners[vertex % 6];
}

// Returns the visible radius of a ball, in the plane of its center: with perspective wider than the ball. World, m.
float SilhouetteRadius(float3 center, float radius)
{
    if (!IsOrthographic())
    {
        float distanceSquared = EyeDistanceSquared(center);
        radius *= sqrt(distanceSquared / max(distanceSquared - radius * radius, 1e-4 * distanceSquared));
    }
    return radius;
}

// Unit; across a unit vector that looks away from the eye.
float3 SideOf(float3 ray)
{
    return normalize(cross(abs(ray.y) < 0.99 ? float3(0, 1, 0) : float3(1, 0, 0), ray));
}

// A point of the quad around a center, world; the quad's edges are at a distance of size.
float3 PointOnQuad(float3 center, float2 corner, float size)
{
    float3 ray = -ToEye(center);
    float3 side = SideOf(ray);
    return center + (side * corner.x + cross(ray, side) * corner.y) * size;
}

#endif
