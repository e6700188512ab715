using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill
{
    // Forces of the fluid on colliders: requested after the steps of a frame, and handed to them when they have come.
    sealed partial class ColliderRegistry
    {
        // A collider whose sums are pending.
        struct Taken
        {
            public IFluidCollider owner;
            public RelativeMotion motion;
            public Vector3 position;    // world space, m
            public float arm;       // of the moment, d
            public bool delivered;
        }

        Taken[] taken;
        int takenCount;
        double takenImpulse;        // N s of a displacement of one particle by d
        Quaternion takenRotation;
        Vector3 takenShift;         // of the fluid, when they were taken
        int takenStep;

        /// <summary>Records the handing over of the sums since the last.</summary>
        /// <param name="rotation">Rotation of the domain, world space.</param>
        /// <param name="fluid">Whose steps they are.</param>
        public void RecordTake(CommandBuffer commands, ColliderReactions reactions, in StepInput input, in DomainFrame frame,
            Quaternion rotation, FluidSimulation fluid)
        {
            taken ??= new Taken[ColliderSet.MaxCount];
            takenCount = Set.Count;
            for (int i = 0; i < takenCount; i++)
            {
                taken[i].owner = entries[i].owner;
                taken[i].arm = Set.Items[i].MomentArm;
                taken[i].position = frame.WorldPoint(Set.Items[i].end.position);
                if (Set.Items[i].reacts)
                    taken[i].motion = entries[i].track.Take();
            }
            takenRotation = rotation;
            takenStep = fluid.StepCount;
            takenShift = fluid.Box.WorldShift;
            double d = frame.Spacing;
            takenImpulse = input.phases.Heaviest(input.material) * d * d * d * d * input.settings.substeps / input.timeStep
                / VelocityExtrapolation.FractionAtOnce(input);
            reactions.RecordTake(commands);
        }

        /// <summary>Hands the forces that have come to the colliders that are still there, then tells who listens to contacts.</summary>
        /// <param name="spacing">m.</param>
        public void Deliver(ColliderReactions reactions, FluidSimulation fluid, float spacing)
        {
            if (reactions == null || !(reactions.Duration > 0f))
                return;
            double scale = -takenImpulse / reactions.Duration;
            for (int i = 0; i < takenCount; i++)
            {
                taken[i].delivered = false;
                try
                {
                    Deliver(reactions, fluid, spacing, scale, i);
                }
                catch (Exception problem)
                {
                    fluid.Inputs.Thrown.Log(problem, taken[i].owner, fluid);
                }
            }
            // Changes by listeners, such as a restart of the fluid, act on the next result.
            for (int i = 0; i < takenCount; i++)
                if (taken[i].delivered)
                    taken[i].owner.RaiseContacts(fluid);
        }

        void Deliver(ColliderReactions reactions, FluidSimulation fluid, float spacing, double scale, int index)
        {
            IFluidCollider owner = taken[index].owner;
            bool left = index >= Set.Count || !ReferenceEquals(entries[index].owner, owner);
            if (left || !owner.IsAlive || !owner.MeasuresForce)
                return;
            reactions.Get(index, out double3 sum, out double3 moment);
            var force = (Vector3)(float3)(sum * scale);
            var torque = (Vector3)(float3)(moment * (scale * spacing * taken[index].arm));
            WettedArea wetted = reactions.HasWettedAreas ? TakenArea(reactions, fluid, spacing, index) : default;
            owner.SetForce(new FluidForce(fluid, takenRotation * force, takenRotation * torque, taken[index].motion,
                reactions.Duration, takenStep, takenShift, wetted));
            taken[index].delivered = true;
        }

        WettedArea TakenArea(ColliderReactions reactions, FluidSimulation fluid, float spacing, int index)
        {
            double area = reactions.WettedArea(index, out double3 facing, out double3 at);
            if (!(area > 0.0))
                return default;
            Vector3 position = taken[index].position + fluid.Box.WorldShift - takenShift;
            var offset = (Vector3)(float3)(at * (taken[index].arm * spacing / area));
            double3 mean = facing / area;
            return new WettedArea((float)(area * spacing * spacing), position + takenRotation * offset,
                math.length(mean) > WettedArea.MinFacing ? takenRotation * (Vector3)(float3)math.normalize(mean) : Vector3.zero);
        }

        /// <summary>Drops the forces on colliders of a fluid that begins again, or goes on from another state: also what is pending.</summary>
        public void DropForces(FluidSimulation fluid)
        {
            for (int i = 0; i < Set.Count; i++)
                entries[i].owner.Leave(fluid);
            leavers.Clear();
            takenCount = 0;
            Set.Order++;        // sums begin again
        }

        /// <summary>Calls the listeners of colliders that have left the box. They may do anything to the scene.</summary>
        public void RaiseExit(FluidSimulation fluid)
        {
            for (int i = 0; i < leavers.Count; i++)
            {
                try
                {
                    leavers[i].RaiseExit(fluid);
                }
                catch (Exception problem)
                {
                    fluid.Inputs.Thrown.Log(problem, leavers[i], fluid);
                }
            }
            leavers.Clear();
        }
    }
}
