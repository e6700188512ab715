using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    // The points of a batch: each is asked as a probe is.
    public sealed partial class FluidQueryBatch
    {
        const float DefaultRadius = 0.1f;

        NativeArray<float3> points;         // world space, m
        NativeArray<float4> pointUpload;    // in the domain, d
        int pointCount;
        float radius = DefaultRadius;

        /// <summary>Most points, as it was made for.</summary>
        public int PointCapacity { get; }

        /// <summary>Points that are asked for, 0 to <see cref="PointCapacity"/>. Those that more of them adds have no sample until they are
        /// set.</summary>
        /// <exception cref="ArgumentOutOfRangeException">It is out of range.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public int PointCount
        {
            get => pointCount;
            set
            {
                CheckCount(value, PointCapacity, "points", nameof(value));
                for (int i = pointCount; i < value; i++)
                    points[i] = float.NaN;
                SetPointCount(value);
            }
        }

        /// <summary>Radius of the ball around each point whose submerged fraction is given, m, above 0.</summary>
        /// <exception cref="ArgumentOutOfRangeException">It is not above 0.</exception>
        public float Radius
        {
            get => radius;
            set
            {
                if (!(value > 0f) || float.IsInfinity(value))
                    throw Limit.OutOfRange(nameof(value), value, "The radius of a submerged ball is above 0 m.");
                radius = value;
            }
        }

        /// <summary>Asks at these points from now on, instead of those before. They are copied.</summary>
        /// <param name="positions">World space, m. For a part of an array, give a sub-array.</param>
        /// <exception cref="ArgumentException">More than <see cref="PointCapacity"/>, or an array that is not created.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public void SetPoints(NativeArray<float3> positions)
        {
            if (!positions.IsCreated)
                throw new ArgumentException("The array of points is not created.", nameof(positions));
            CheckCount(positions.Length, PointCapacity, "points", nameof(positions));
            NativeArray<float3>.Copy(positions, points, positions.Length);
            SetPointCount(positions.Length);
        }

        /// <summary>Sets the points from a part of an array.</summary>
        /// <param name="positions">World space, m.</param>
        /// <param name="start">The first that is taken.</param>
        /// <param name="count">How many are taken.</param>
        /// <exception cref="ArgumentNullException">No array.</exception>
        /// <exception cref="ArgumentOutOfRangeException">The part is not in the array, or more than <see cref="PointCapacity"/>.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public void SetPoints(Vector3[] positions, int start, int count)
        {
            if (positions == null)
                throw new ArgumentNullException(nameof(positions));
            CheckPart(positions.Length, start, count, "points");
            CheckCount(count, PointCapacity, "points", nameof(count));
            for (int i = 0; i < count; i++)
                points[i] = positions[start + i];
            SetPointCount(count);
        }

        /// <summary>Sets the points from a list.</summary>
        /// <param name="positions">World space, m.</param>
        /// <exception cref="ArgumentNullException">No list.</exception>
        /// <exception cref="ArgumentException">More than <see cref="PointCapacity"/>.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public void SetPoints(List<Vector3> positions)
        {
            if (positions == null)
                throw new ArgumentNullException(nameof(positions));
            CheckCount(positions.Count, PointCapacity, "points", nameof(positions));
            for (int i = 0; i < positions.Count; i++)
                points[i] = positions[i];
            SetPointCount(positions.Count);
        }

        /// <summary>Moves one of the points.</summary>
        /// <param name="index">0 to below <see cref="PointCount"/>.</param>
        /// <param name="position">World space, m.</param>
        /// <exception cref="ArgumentOutOfRangeException">The index is not one of a point.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public void SetPoint(int index, Vector3 position)
        {
            NeedAlive();
            CheckIndex(index, pointCount, "points", nameof(PointCount));
            points[index] = position;
            version++;
        }

        /// <summary>The newest sample of a point, a few frames old; its age is that of this call, its position where the point was then.</summary>
        /// <param name="index">0 to below <see cref="PointCapacity"/>.</param>
        /// <param name="sample">What was found.</param>
        /// <returns>Whether it is valid: false before the first since the fluid started, while the fluid is off, where the point was outside
        /// the fluid's box or not finite, and for a point that was not asked for yet.</returns>
        /// <exception cref="ArgumentOutOfRangeException">The index is not one of a point.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public bool TryGetSample(int index, out FluidProbeSample sample)
        {
            NeedAlive();
            CheckIndex(index, PointCapacity, "points", nameof(PointCapacity));
            sample = default;
            if (!HasResult || index >= questions[newest].pointCount)
                return false;
            sample = Sample(questions[newest], index, buffers.Latest(newest));
            return sample.valid;
        }

        /// <summary>Copies the newest samples of all points, the same point to the same index; each says whether it is valid.</summary>
        /// <param name="samples">At least as many as were asked for.</param>
        /// <returns>How many there are; 0 before the first result.</returns>
        /// <exception cref="ArgumentException">The array is too short; nothing was copied.</exception>
        /// <exception cref="ObjectDisposedException">The batch was disposed of.</exception>
        public int CopySamples(NativeArray<FluidProbeSample> samples)
        {
            NeedAlive();
            if (!HasResult)
                return 0;
            PendingQuestions of = questions[newest];
            CheckRoom(samples.Length, of.pointCount, PointCapacity, nameof(PointCapacity), nameof(samples));
            NativeArray<uint> words = buffers.Latest(newest);
            for (int i = 0; i < of.pointCount; i++)
                samples[i] = Sample(of, i, words);
            return of.pointCount;
        }

        FluidProbeSample Sample(PendingQuestions of, int index, NativeArray<uint> words)
        {
            float4 point = of.points[index];
            Vector3 position = (Vector3)point.xyz + (fluid.Box.WorldShift - of.frame.shift);
            FluidProbeSample sample = QueryResults.Probe(of.frame, words, buffers.PointAt(index), position, point.w > 0f, radius);
            sample.age = AgeOf(of);
            return sample;
        }

        void GatherPoints(PendingQuestions to, in DomainFrame domain, float3 size)
        {
            to.pointCount = pointCount;
            for (int i = 0; i < pointCount; i++)
            {
                float3 point = domain.Point(points[i]);
                bool isInside = math.all(point >= 0f) && math.all(point <= size);      // not so where it is not finite
                to.points[i] = new float4(points[i], isInside ? 0f : 1f);
                pointUpload[i] = isInside ? new float4(point, 0f) : 0f;
            }
        }

        void SetPointCount(int count)
        {
            pointCount = count;
            version++;
        }
    }
}
