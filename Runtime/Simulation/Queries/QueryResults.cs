using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>Reads what came back of a question: from words in the box's frame to world space and SI units.</summary>
    static class QueryResults
    {
        const float MinSteepness = 0.2f;        // of the normal along gravity: a steeper surface rises no faster

        /// <param name="words">Result words of all queries.</param>
        /// <param name="at">The first word of this one.</param>
        /// <param name="position">Where it was asked, m.</param>
        /// <param name="isOutside">Whether that was outside the box: then nothing is valid.</param>
        /// <param name="radius">Radius of the ball whose submerged fraction is given, m.</param>
        public static FluidProbeSample Probe(in QueryFrame frame, NativeArray<uint> words, int at, Vector3 position, bool isOutside, float radius)
        {
            var sample = new FluidProbeSample { step = frame.step, time = frame.time, position = position };
            if (isOutside)
                return sample;
            var flags = (ProbeFlag)words[at + (int)ProbeWord.Flags];
            sample.valid = true;
            sample.density = Value(words, at + (int)ProbeWord.Density);
            sample.hasVelocity = (flags & ProbeFlag.NearWater) != 0;
            if (sample.hasVelocity)
            {
                sample.velocity = frame.rotation * (Vector(words, at + (int)ProbeWord.Velocity) * frame.spacing);
                sample.phase = (int)words[at + (int)ProbeWord.Phase];
            }
            sample.hasSurface = (flags & ProbeFlag.HasSurface) != 0;
            if (!sample.hasSurface)
                return sample;
            float above = Value(words, at + (int)ProbeWord.Height) * frame.spacing;
            sample.depth = above;
            sample.surfacePoint = position + frame.up * above;
            sample.height = Vector3.Dot(sample.surfacePoint, frame.up);
            sample.normal = frame.rotation * Vector(words, at + (int)ProbeWord.Normal);
            sample.surfaceVelocity = frame.rotation * (Vector(words, at + (int)ProbeWord.SurfaceVelocity) * frame.spacing);
            sample.heightRate = Vector3.Dot(sample.surfaceVelocity, sample.normal)
                / math.max(Vector3.Dot(sample.normal, frame.up), MinSteepness);
            sample.submerged = FractionOfBall(above * Vector3.Dot(sample.normal, frame.up) / radius);
            return sample;
        }

        /// <param name="at">The first word of this ray.</param>
        /// <param name="frameOfBox">From the box's frame, d, to world space.</param>
        public static FluidRayHit Ray(in QueryFrame frame, in DomainFrame frameOfBox, NativeArray<uint> words, int at, in FluidRay ray)
        {
            var flags = (RayFlag)words[at + (int)RayWord.Flags];
            var found = new FluidRayHit { valid = true, step = frame.step, time = frame.time, ray = ray };
            found.startsInWater = (flags & RayFlag.StartsInWater) != 0;
            found.hit = (flags & RayFlag.Hit) != 0;
            if (!found.hit)
                return found;
            found.distance = Value(words, at + (int)RayWord.Distance) * frame.spacing;
            found.point = frameOfBox.WorldPoint(Vector(words, at + (int)RayWord.Point));
            found.normal = frame.rotation * Vector(words, at + (int)RayWord.Normal);
            found.velocity = frame.rotation * (Vector(words, at + (int)RayWord.Velocity) * frame.spacing);
            found.phase = (int)words[at + (int)RayWord.Phase];
            return found;
        }

        /// <summary>Fraction of a ball that lies below a plane this far above its center, in radii.</summary>
        public static float FractionOfBall(float above)
        {
            float h = math.clamp(above, -1f, 1f) + 1f;
            return h * h * (3f - h) * 0.25f;
        }

        static float Value(NativeArray<uint> words, int at) => math.asfloat(words[at]);

        static Vector3 Vector(NativeArray<uint> words, int at) => new Vector3(Value(words, at), Value(words, at + 1), Value(words, at + 2));
    }
}
