// A triangle, and how far and how wide it is seen from a point. Lengths in any unit.
#ifndef RILL_TRIANGLE_INCLUDED
#define RILL_TRIANGLE_INCLUDED

struct Triangle
{
    float3 a, b, c;
};

static const float kTinySquare = 1e-30;     // guards divisions by an edge without length

// Squared distance of the point p from the segment from 0 to 'edge'.
float SegmentDistanceSquared(float3 p, float3 edge)
{
    float3 off = p - saturate(dot(p, edge) / max(dot(edge, edge), kTinySquare)) * edge;
    return dot(off, off);
}

// Squared distance of the point p from a triangle: from its edges, or from its inside where p is above that. Each of the
// four is the distance to a point of the triangle, so that rounding can make the least of them too large but hardly
// too small, however thin the triangle is.
float TriangleDistanceSquared(Triangle t, float3 p)
{
    float3 ab = t.b - t.a;
    float3 ac = t.c - t.a;
    float3 ap = p - t.a;
    float least = min(SegmentDistanceSquared(ap, ab), min(SegmentDistanceSquared(ap, ac), SegmentDistanceSquared(p - t.b, t.c - t.b)));

    float bb = dot(ab, ab);
    float bc = dot(ab, ac);
    float cc = dot(ac, ac);
    float area = bb * cc - bc * bc;
    if (area > 0.0)
    {
        float2 foot = float2(cc * dot(ab, ap) - bc * dot(ac, ap), bb * dot(ac, ap) - bc * dot(ab, ap)) / area;
        float3 off = ap - foot.x * ab - foot.y * ac;
        // Once more from there: in a thin triangle the first foot is off by more than rounding of the distance.
        foot += float2(cc * dot(ab, off) - bc * dot(ac, off), bb * dot(ac, off) - bc * dot(ab, off)) / area;
        off = ap - foot.x * ab - foot.y * ac;
        if (foot.x >= 0.0 && foot.y >= 0.0 && foot.x + foot.y <= 1.0)
            least = min(least, dot(off, off));
    }
    return least;
}

// Twice the area, along the side that the triangle faces.
float3 TriangleAreaVector(Triangle t)
{
    return cross(t.b - t.a, t.c - t.a);
}

// Winding number of a triangle about p: its solid angle over 4 pi, positive if p is behind it. Van Oosterom and
// Strackee 1983, eq. 8. 0 in the triangle's own plane.
float TriangleWinding(Triangle t, float3 p)
{
    float3 a = t.a - p;
    float3 b = t.b - p;
    float3 c = t.c - p;
    float la = length(a);
    float lb = length(b);
    float lc = length(c);
    float volume = dot(a, cross(b, c));
    float extent = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
    return volume == 0.0 ? 0.0 : atan2(volume, extent) * 0.15915494;
}

#endif
