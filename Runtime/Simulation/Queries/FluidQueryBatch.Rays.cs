using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using static System.FormattableString;

namespace Rill
{
    // The rays of a batch, and the balls that are cast along them.
    public sealed partial class FluidQueryBatch
    {
        NativeArray<FluidRay> rays;
        NativeArray<RayQuery> rayUpload;
        int rayCount;

        /// <summary>Most rays, as it was made for.</summary>
        public int RayCapacity { get; }

        /// <summary>Rays that are cast, 0 to <see cref="RayCapacity"/>. Those that more of them adds have no result until they are set.</summary>
        /// <exception cref="ArgumentOutOfRangeException">It is out of range.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public int RayCount
        {
            get => rayCount;
            set
            {
                CheckCount(value, RayCapacity, "rays", nameof(value));
                for (int i = rayCount; i < value; i++)
                    rays[i] = default;
                SetRayCount(value);
            }
        }

        /// <summary>Casts these rays from now on, instead of those before. They are copied.</summary>
        /// <param name="casts">Rays, and balls. For a part of an array, give a sub-array.</param>
        /// <exception cref="ArgumentException">More than <see cref="RayCapacity"/>, an array that is not created, or a ray that cannot be cast,
        /// which is named with what to do; the rays of before stay.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public void SetRays(NativeArray<FluidRay> casts)
        {
            if (!casts.IsCreated)
                throw new ArgumentException("The array of rays is not created.", nameof(casts));
            CheckCount(casts.Length, RayCapacity, "rays", nameof(casts));
            for (int i = 0; i < casts.Length; i++)
                Check(casts[i], i, nameof(casts));
            NativeArray<FluidRay>.Copy(casts, rays, casts.Length);
            SetRayCount(casts.Length);
        }

        /// <summary>Sets the rays from a part of an array.</summary>
        /// <param name="casts">Rays, and balls.</param>
        /// <param name="start">The first that is taken.</param>
        /// <param name="count">How many are taken.</param>
        /// <exception cref="ArgumentNullException">No array.</exception>
        /// <exception cref="ArgumentException">The part is not in the array, more than <see cref="RayCapacity"/>, or a ray that cannot be cast;
        /// the rays of before stay.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public void SetRays(FluidRay[] casts, int start, int count)
        {
            if (casts == null)
                throw new ArgumentNullException(nameof(casts));
            CheckPart(casts.Length, start, count, "rays");
            CheckCount(count, RayCapacity, "rays", nameof(count));
            for (int i = 0; i < count; i++)
                Check(casts[start + i], start + i, nameof(casts));
            for (int i = 0; i < count; i++)
                rays[i] = casts[start + i];
            SetRayCount(count);
        }

        /// <summary>Sets the rays from a list.</summary>
        /// <param name="casts">Rays, and balls.</param>
        /// <exception cref="ArgumentNullException">No list.</exception>
        /// <exception cref="ArgumentException">More than <see cref="RayCapacity"/>, or a ray that cannot be cast; the rays of before
        /// stay.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public void SetRays(List<FluidRay> casts)
        {
            if (casts == null)
                throw new ArgumentNullException(nameof(casts));
            CheckCount(casts.Count, RayCapacity, "rays", nameof(casts));
            for (int i = 0; i < casts.Count; i++)
                Check(casts[i], i, nameof(casts));
            for (int i = 0; i < casts.Count; i++)
                rays[i] = casts[i];
            SetRayCount(casts.Count);
        }

        /// <summary>Changes one of the rays.</summary>
        /// <param name="index">0 to below <see cref="RayCount"/>.</param>
        /// <param name="cast">A ray, or a ball.</param>
        /// <exception cref="ArgumentOutOfRangeException">The index is not one of a ray.</exception>
        /// <exception cref="ArgumentException">It cannot be cast; the message says why.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public void SetRay(int index, in FluidRay cast)
        {
            NeedAlive();
            CheckIndex(index, rayCount, "rays", nameof(RayCount));
            Check(cast, index, nameof(cast));
            rays[index] = cast;
            version++;
        }

        /// <summary>The newest result of a ray, a few frames old; its age is that of this call.</summary>
        /// <param name="index">0 to below <see cref="RayCapacity"/>.</param>
        /// <param name="found">What was found, and the ray that was cast.</param>
        /// <returns>Whether it is valid: false before the first since the fluid started, while the fluid is off, and for a ray that was not
        /// cast yet. A valid one may have missed: ask <see cref="FluidRayHit.hit"/>.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The index is not one of a ray.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public bool TryGetHit(int index, out FluidRayHit found)
        {
            NeedAlive();
            CheckIndex(index, RayCapacity, "rays", nameof(RayCapacity));
            found = default;
            if (!HasResult || index >= questions[newest].rayCount)
                return false;
            found = Hit(questions[newest], index, buffers.Latest(newest));
            return found.valid;
        }

        /// <summary>Copies the newest results of all rays, the same ray to the same index; each says whether it is valid.</summary>
        /// <param name="hits">At least as many as were cast.</param>
        /// <returns>How many there are; 0 before the first result.</returns>
        /// <exception cref="ArgumentException">The array is too short; nothing was copied.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public int CopyHits(NativeArray<FluidRayHit> hits)
        {
            NeedAlive();
            if (!HasResult)
                return 0;
            PendingQuestions of = questions[newest];
            CheckRoom(hits.Length, of.rayCount, RayCapacity, nameof(RayCapacity), nameof(hits));
            NativeArray<uint> words = buffers.Latest(newest);
            for (int i = 0; i < of.rayCount; i++)
                hits[i] = Hit(of, i, words);
            return of.rayCount;
        }

        FluidRayHit Hit(PendingQuestions of, int index, NativeArray<uint> words)
        {
            FluidRay ray = of.rays[index];
            if (ray.direction == Vector3.zero)      // it was not set
                return new FluidRayHit { step = of.frame.step, time = of.frame.time };
            FluidRayHit found = QueryResults.Ray(of.frame, of.domain, words, buffers.RayAt(index), ray);
            found.Shift(fluid.Box.WorldShift - of.frame.shift);
            found.age = AgeOf(of);
            return found;
        }

        // The longest that any of them can be in the box, d.
        float GatherRays(PendingQuestions to, in DomainFrame domain, float3 size)
        {
            float longest = 0f;
            to.rayCount = rayCount;
            if (rayCount > 0)
                NativeArray<FluidRay>.Copy(rays, to.rays, rayCount);
            for (int i = 0; i < rayCount; i++)
            {
                FluidRay ray = rays[i];
                bool isSet = ray.direction != Vector3.zero;
                float3 direction = isSet ? math.normalize(domain.Vector(ray.direction)) : new float3(0f, 1f, 0f);
                float ball = math.min(ray.radius / domain.Spacing, RayQuery.MaxRadius);     // the spacing may have changed
                float length = isSet ? ray.maxDistance / domain.Spacing : -1f;
                rayUpload[i] = new RayQuery
                {
                    origin = domain.Point(ray.origin),
                    maxDistance = math.min(length, float.MaxValue),
                    direction = direction,
                    radius = ball,
                    crossings = (uint)ray.crossing,
                    lines = (uint)RayQuery.LinesFor(ball),
                };
                longest = math.max(longest, math.min(length, math.dot(math.abs(direction), size)));
            }
            return longest;
        }

        void Check(in FluidRay cast, int index, string name)
        {
            if (fluid != null && cast.Problem(fluid.ParticleSpacing) is string problem)
                throw new ArgumentException(Invariant($"Ray {index} {problem}."), name);
        }

        void SetRayCount(int count)
        {
            rayCount = count;
            version++;
        }
    }
}
