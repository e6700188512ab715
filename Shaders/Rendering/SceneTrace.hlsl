// Follows rays over the picture to the opaque scene, by its depth (McGuire and Mara 2014). Include after SceneColor.hlsl.
#ifndef RILL_SCENE_TRACE_INCLUDED
#define RILL_SCENE_TRACE_INCLUDED

static const uint kTraceRefinements = 6;
static const float kEdgePixels = 4.0;
static const float kMirroredPart = 0.3;
static const float kTraceSlack = 0.01;      // of the depth: as thick as this the scene is taken to be at least

struct SceneTrace
{
    bool found;             // the ray meets the scene
    bool open;              // nothing hides its end, which is on the picture
    bool hidden;            // something nearer hides where it would meet it
    float reach;            // part of the ray up to there; else 1
    float2 picture;         // where the scene is met; where that is hidden, beside what hides it
};

// A ray on the picture: points of it are linear there, and so is the device's depth.
struct PictureRay
{
    float3 from, to;        // x and y of the picture, z of SurfaceClip
    float fromW, toW;
};

float3 OnPicture(PictureRay r, float s)
{
    return lerp(r.from, r.to, s);
}

// Depth along the view, m, beyond the picture too: as if what is at its border went on there as a plane, whose device depth is linear.
float ExtendedSceneDepth(float2 picture)
{
    float2 texel = 2.0 / SceneSize(), inside = clamp(picture, texel - 1.0, 1.0 - texel), beyond = picture - inside;
    float depth = FlipDepth(SceneDepth(inside, eyeIndex));
    float outside = length(beyond);
    if (outside > texel.y)
    {
        float baseline = 0.06;      // of half the picture
        float further = FlipDepth(SceneDepth(inside - beyond / outside * baseline, eyeIndex));
        float extended = depth + (depth - further) * (outside / baseline);
        // No plane goes on so steeply: that is an edge.
        depth = clamp(extended, 0.5 * depth, 2.0 * depth);
    }
    return FromSceneDepth(depth, picture, eyeIndex);
}

// From a point of the world along a path, m, in at most so many steps. border: how far it is followed, of half the picture; beyond 1 the scene is
// a guess, and `picture` at the border.
SceneTrace TraceScene(float3 from, float3 path, uint maxSteps, float border)
{
    SceneTrace result;
    result.found = false;
    result.open = false;
    result.hidden = false;
    result.reach = 1.0;

    float4 a = SurfaceClip(from, eyeIndex), b = SurfaceClip(from + path, eyeIndex);
    result.picture = a.xy / max(a.w, 1e-6);
    if (a.w < 1e-5)
        return result;
    // Not behind the eye.
    float nearest = 0.02 * a.w, shortened = 1.0;
    if (b.w < nearest)
    {
        shortened = (a.w - nearest) / max(a.w - b.w, 1e-9);
        b = lerp(a, b, shortened);
    }
    PictureRay r;
    r.from = a.xyz / a.w;
    r.to = b.xyz / b.w;
    r.fromW = a.w;
    r.toW = b.w;
    // Limits it to the picture.
    float2 shift = r.to.xy - r.from.xy;
    float2 room = (border - r.from.xy * sign(shift)) / max(abs(shift), 1e-6);
    float last = saturate(min(room.x, room.y));

    float pixels = length(shift * last * 0.5 * SceneSize());
    uint steps = clamp((uint)(pixels * 0.5) + 1, 1, maxSteps);
    float s = 0.0, before = 0.0, beforeZ = 0.0, seen = 0.0, low = 0.0, lowZ = 0.0, high = 0.0, highZ = 0.0, highBehind = 0.0;
    bool wasBehind = true, isRefining = false, isDone = false;
    uint step = 0, refined = 0;
    [loop]
    for (uint i = 0; i < maxSteps + 3 * kTraceRefinements && !isDone; i++)
    {
        float3 at = OnPicture(r, s);
        float z = FromSurfaceDepth(at.z, eyeIndex), behind = z - ExtendedSceneDepth(at.xy);
        if (isRefining)
        {
            if (behind > 0.0)
            {
                high = s;
                highZ = z;
                highBehind = behind;
            }
            else
            {
                low = s;
                lowZ = z;
            }
            refined++;
            if (refined == kTraceRefinements)
            {
                // Still far behind: it goes behind an edge, up to which it is seen, but for what a filtered sample would take of the edge.
                result.found = isDone = highBehind < kTraceSlack * highZ + 2.0 * abs(highZ - lowZ);
                seen = max(0.0, low - kEdgePixels * last / max(pixels, 1e-3));
                isRefining = false;
                wasBehind = true;
            }
        }
        else
        {
            bool isBehind = behind > (step == 0 ? kTraceSlack * z : 0.0);
            if (isBehind && !wasBehind)
            {
                isRefining = true;
                refined = 0;
                low = before;
                lowZ = beforeZ;
                high = s;
                highZ = z;
                highBehind = behind;
            }
            else
            {
                seen = isBehind ? seen : s;
                wasBehind = isBehind;
            }
            before = s;
            beforeZ = z;
        }
        if (isRefining)
            s = 0.5 * (low + high);
        else if (!isDone)
        {
            isDone = step == steps;
            step++;
            s = last * step / steps;
        }
    }
    result.open = !result.found && !wasBehind && last == 1.0 && shortened == 1.0;
    result.hidden = !result.found && wasBehind;
    float ends = result.found ? high : last;
    float shown = result.found ? high : seen;
    // A hidden part is replaced by what is visible beside it, mirrored at the edge of what hides it, and drawn out, so that little is seen twice.
    if (result.hidden)
        shown = max(0.0, seen - kMirroredPart * (last - seen));
    // Beyond the picture nothing is known: its border is seen.
    result.picture = clamp(OnPicture(r, shown).xy, -1.0, 1.0);
    result.reach = shortened * ends * r.fromW / max(lerp(r.toW, r.fromW, ends), 1e-9);
    return result;
}

// 1 in the picture, 0 at its borders; width: over which it falls, of half the picture's.
float BorderFade(float2 picture, float width)
{
    float2 inside = (1.0 - abs(picture)) / width;
    return smoothstep(0.0, 1.0, saturate(min(inside.x, inside.y)));
}

#endif
