using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// Surroundings of a body in one fluid: solids so near that no particle comes between, and the level of the water beside it. Looked
    /// for where a solid is near while water touches the body, for bodies of so little draft that single particles would carry them, and while
    /// the fluid drops time.
    /// </summary>
    sealed class BodySurroundings : IDisposable
    {
        const float Closed = 1.5f, Open = 2.5f;         // d: a gap that water hardly enters, and one that has its water
        const float MinFacing = 0.3f;                   // cosine from which a solid lies before a face
        // d, from the body to the points that are asked for the level: far where it lies near a solid and there is room, since over ground water
        // stands higher at its sides, by up to 0.6 d.
        const float NearDistance = 1.5f, FarDistance = 3f;
        const float LightDraft = 1f, HeavyDraft = 2f;   // d: up to the one the level alone carries a body, from the other what is measured
        const float Patience = 1f;                      // s without need, after which nothing is asked any more

        readonly List<ColliderDistance> solids = new List<ColliderDistance>();
        readonly List<SurfaceSample> samples = new List<SurfaceSample>();
        readonly FluidSimulation fluid;
        SurroundingWater water;      // null while not needed
        float unneeded;
        DomainFrame frame;
        float3 size;            // of the domain, d
        bool isNearWall;

        public BodySurroundings(FluidSimulation fluid) => this.fluid = fluid;

        public FluidSimulation Fluid => fluid;

        /// <summary>Density of the liquid around the body, kg/m³: of several, the mean of those beside it.</summary>
        public float Density => fluid.Phases.Differ && water != null && water.Density > 0f ? water.Density : fluid.Material.density;

        /// <summary>Looks around the body.</summary>
        /// <param name="center">Center of mass, world space, m.</param>
        /// <param name="touches">Whether the fluid presses on it.</param>
        /// <param name="time">Since the last look, s.</param>
        /// <param name="knownLevel">Level of the water by what was measured, used until the requested one has come; NaN if unknown.</param>
        /// <returns>All 0 where what was measured needs nothing beside it.</returns>
        public StillWater Look(List<BodyPart> parts, float mass, Vector3 center, bool touches, float time, float knownLevel)
        {
            bool isMixed = touches && fluid.Phases.Differ;
            if (isMixed)
                water?.Read();
            Vector3 gravity = fluid.Gravity;
            float g = gravity.magnitude, weight = g > 0f ? Weight(parts, mass, gravity / -g) : 0f;
            bool isNear = (touches || weight > 0f) && g > 0f && FindSolids(parts);
            if (!isNear && !(weight > 0f) && !(isMixed && g > 0f))
            {
                unneeded += time;
                if (unneeded > Patience)
                    Dispose();
                return default;
            }
            unneeded = 0f;
            Vector3 up = gravity / -g;
            RequestWater(parts, up, isNear);
            if (!water.IsAnswered && !float.IsNaN(knownLevel))
                water.Assume(knownLevel);
            if (!water.HasWater)
                return new StillWater { isPending = !water.IsAnswered && fluid.Clock.DropsTime && weight > 0f };
            samples.Clear();
            foreach (BodyPart part in parts)
                SurfaceSamples.Append(samples, part.shape, part.field, fluid.ParticleSpacing);
            return Sum(center, up, Density * g, isNear, weight);
        }

        /// <summary>Puts what was asked into a snapshot.</summary>
        /// <returns>Null where nothing was.</returns>
        public SnapshotWater Save(SnapshotCapture capture)
        {
            if (water == null)
                return null;
            var saved = new SnapshotWater { unneeded = unneeded };
            water.Save(saved, capture);
            return saved;
        }

        /// <summary>Takes it out of one.</summary>
        /// <param name="moved">How far the fluid is from where it was, m.</param>
        public void Load(SnapshotWater from, Vector3 moved)
        {
            Dispose();
            unneeded = from.unneeded;
            water = new SurroundingWater(fluid);
            water.Load(from, moved);
        }

        public void Dispose()
        {
            water?.Dispose();
            water = null;
        }

        // How far the level alone carries a body: by its draft as a prism, and where the fluid drops time, so that a force is too old to
        // tell of heave. A hull that floats by the air in it has less volume than it displaces: of that no level tells.
        float Weight(List<BodyPart> parts, float mass, Vector3 up)
        {
            float volume = 0f, low = float.PositiveInfinity, high = float.NegativeInfinity;
            foreach (BodyPart part in parts)
            {
                float center = Vector3.Dot(part.shape.end.position, up), half = 0.5f * ColliderMeasures.Width(part.shape, up);
                low = math.min(low, center - half);
                high = math.max(high, center + half);
                volume += part.volume;
            }
            if (fluid.Clock.DropsTime && mass < Density * volume)
                return 1f;
            float draft = mass / (Density * volume) * (high - low) / fluid.ParticleSpacing;
            return math.saturate((HeavyDraft - draft) / (HeavyDraft - LightDraft));
        }

        // Those whose surface may come before a face of the body. The domain's walls are solids too.
        bool FindSolids(List<BodyPart> parts)
        {
            frame = fluid.Box.Frame;
            size = fluid.DomainSize / fluid.ParticleSpacing;
            solids.Clear();
            isNearWall = false;
            ColliderSet set = fluid.Inputs.Colliders.Set;
            for (int i = 0; i < set.Count; i++)
                if (MayBeNear(parts, set.Items[i]) && !IsOwn(parts, fluid.Inputs.Colliders.OwnerOf(i))
                    && ColliderDistance.TryMake(set.Items[i], out ColliderDistance solid) && IsNear(parts, solid))
                    solids.Add(solid);
            foreach (BodyPart part in parts)
                for (int axis = 0; axis < 3; axis++)
                {
                    float3 one = default;
                    one[axis] = 1f;
                    Vector3 along = (frame.WorldPoint(one) - frame.WorldPoint(0f)).normalized;
                    float half = 0.5f * ColliderMeasures.Width(part.shape, along) / fluid.ParticleSpacing;
                    float at = frame.Point(part.shape.end.position)[axis];
                    isNearWall |= math.min(at, size[axis] - at) < half + Open;
                }
            return isNearWall || solids.Count > 0;
        }

        bool MayBeNear(List<BodyPart> parts, in ColliderMotion solid)
        {
            if (solid.shape == ColliderShape.Plane || solid.shape == ColliderShape.HeightField || solid.insideOut)
                return true;
            foreach (BodyPart part in parts)
                if (math.distance(solid.end.position, frame.Point(part.shape.end.position))
                    < solid.Radius + part.shape.Radius / fluid.ParticleSpacing + Open)
                    return true;
            return false;
        }

        static bool IsOwn(List<BodyPart> parts, IFluidCollider owner)
        {
            foreach (BodyPart part in parts)
                if (ReferenceEquals(part.collider, owner))
                    return true;
            return false;
        }

        bool IsNear(List<BodyPart> parts, in ColliderDistance solid)
        {
            foreach (BodyPart part in parts)
                if (solid.At(frame.Point(part.shape.end.position)) < part.shape.Radius / fluid.ParticleSpacing + Open)
                    return true;
            return false;
        }

        // Requests the water at points around the body, as high as its center.
        void RequestWater(List<BodyPart> parts, Vector3 up, bool isNearSolid)
        {
            if (water == null)
                water = new SurroundingWater(fluid);
            water.Clear();
            Vector3 center = Vector3.zero;
            foreach (BodyPart part in parts)
                center += (Vector3)part.shape.end.position / parts.Count;
            frame = fluid.Box.Frame;
            Vector3 right = Vector3.Cross(up, Mathf.Abs(up.x) < 0.7f ? Vector3.right : Vector3.forward).normalized;
            Vector3 forward = Vector3.Cross(right, up);
            for (int i = 0; i < SurroundingWater.MaxPoints; i++)
            {
                math.sincos(2f * math.PI * i / SurroundingWater.MaxPoints, out float sine, out float cosine);
                Vector3 direction = cosine * right + sine * forward;
                float reach = 0f;
                foreach (BodyPart part in parts)
                    reach = math.max(reach, Vector3.Dot((Vector3)part.shape.end.position - center, direction)
                        + 0.5f * ColliderMeasures.Width(part.shape, direction));
                Vector3 side = center + direction * reach;
                Vector3 far = side + direction * (FarDistance * fluid.ParticleSpacing);
                Vector3 near = side + direction * (NearDistance * fluid.ParticleSpacing);
                if (isNearSolid && IsFree(frame.Point(far)))
                    water.AddPoint(far);
                else if (IsFree(frame.Point(near)))
                    water.AddPoint(near);
            }
            water.Update();
        }

        bool IsFree(float3 p)
        {
            if (math.any(p < 0f) || math.any(p > size))
                return false;
            foreach (ColliderDistance solid in solids)
                if (solid.At(p) < 0f)
                    return false;
            return true;
        }

        StillWater Sum(Vector3 center, Vector3 up, float weightOfWater, bool isNear, float weight)
        {
            Vector3 velocity = fluid.Clock.RateOfTime * water.Velocity + fluid.Box.Velocity;
            var sum = new StillWater { weight = weight, level = water.Level, velocity = velocity };
            float lowest = float.PositiveInfinity;
            foreach (SurfaceSample sample in samples)
            {
                float height = Vector3.Dot(sample.position, up);
                lowest = math.min(lowest, height);
                Vector3 push = (Vector3)sample.area * -(weightOfWater * water.DepthOf(height));
                float lift = Vector3.Dot(push, up);
                sum.maxLift += math.max(lift, 0f);
                sum.load += math.max(-lift, 0f);
                Vector3 arm = (Vector3)sample.position - center;
                if (weight > 0f)
                {
                    Vector3 whole = (Vector3)sample.area * -(weightOfWater * math.max(water.Level - height, 0f));
                    sum.push += whole;
                    sum.moment += Vector3.Cross(arm, whole);
                }
                float covered = isNear ? Covered(frame.Point(sample.position), frame.Vector(sample.area)) : 0f;
                if (covered <= 0f)
                    continue;
                sum.coveredPush += covered * push;
                sum.coveredMoment += covered * Vector3.Cross(arm, push);
            }
            sum.contact = math.saturate(1f + (water.Level - lowest) / (0.5f * fluid.ParticleSpacing));
            return sum;
        }

        // How far a solid lies before a face, so near that no particle comes between: 0 to 1.
        float Covered(float3 p, float3 direction)
        {
            float3 normal = math.normalizesafe(direction);
            float covered = 0f;
            if (isNearWall)
                for (int axis = 0; axis < 3; axis++)
                {
                    float facing = math.abs(normal[axis]);
                    covered = math.max(covered, Covers(normal[axis] < 0f ? p[axis] : size[axis] - p[axis], facing));
                }
            foreach (ColliderDistance solid in solids)
            {
                float distance = solid.At(p);
                if (distance < Open && covered < 1f)
                    covered = math.max(covered, Covers(distance, 2f * (distance - solid.At(p + 0.5f * normal))));
            }
            return covered;
        }

        // By the distance from its surface, d, and the cosine under which that comes nearer along the face's normal.
        static float Covers(float distance, float facing)
            => facing > MinFacing ? math.saturate((Open - distance / facing) / (Open - Closed)) : 0f;
    }
}
