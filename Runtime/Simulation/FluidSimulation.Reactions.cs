using System;
using Unity.Mathematics;
using UnityEngine;

namespace Rill
{
    // What the fluid does to colliders: asked for after the steps of a frame, handed to them when it has come.
    public sealed partial class FluidSimulation
    {
        ColliderTrack[] tracks, lastTracks;
        RelativeMotion[] takenMotions;
        FluidCollider[] takenOwners;
        float[] takenArms;
        int takenCount;
        double takenImpulse;        // N s of a displacement of one particle by d
        Quaternion takenRotation;

        void BeginTracks() => (tracks, lastTracks) = (lastTracks, tracks);

        /// <summary>Follows a collider whose force is summed through the coming steps.</summary>
        /// <param name="last">Its number in the last steps; negative where nothing is known of its motion since.</param>
        void Track(int index, int last, in RigidPose pose, float duration)
        {
            tracks ??= new ColliderTrack[ColliderSet.Most];
            lastTracks ??= new ColliderTrack[ColliderSet.Most];
            bool follows = last >= 0 && lastMotions[last].reacts;
            ColliderTrack track = follows ? lastTracks[last] : ColliderTrack.At(pose);
            track.Follow(pose, duration, FixedStep / input.settings.substeps);
            tracks[index] = track;
        }

        /// <summary>Records the handing over of the sums, unless earlier ones are on their way.</summary>
        /// <returns>What to request after the commands ran; null for nothing.</returns>
        ColliderReactions TakeReactions()
        {
            ColliderReactions reactions = pbf.Reactions;
            if (reactions == null || reactions.IsPending)
                return null;
            takenOwners ??= new FluidCollider[ColliderSet.Most];
            takenArms ??= new float[ColliderSet.Most];
            takenMotions ??= new RelativeMotion[ColliderSet.Most];
            reactions.Arrived ??= OnReactions;
            takenCount = colliders.Count;
            Array.Copy(colliderOwners, takenOwners, takenCount);
            for (int i = 0; i < takenCount; i++)
            {
                takenArms[i] = colliders.Items[i].MomentArm;
                if (colliders.Items[i].reacts)
                    takenMotions[i] = tracks[i].Take();
            }
            GetPose(out _, out takenRotation);
            double spacing = particleSpacing;
            takenImpulse = material.density * spacing * spacing * spacing * spacing * input.settings.substeps / FixedStep / VelocityExtrapolation.FractionAtOnce(input);
            reactions.RecordTake(commands);
            return reactions;
        }

        void OnReactions()
        {
            ColliderReactions reactions = pbf?.Reactions;
            if (reactions == null || !(reactions.Duration > 0f))
                return;
            double scale = -takenImpulse / reactions.Duration;
            for (int i = 0; i < takenCount; i++)
            {
                FluidCollider owner = takenOwners[i];
                bool left = i >= colliders.Count || !ReferenceEquals(colliderOwners[i], owner);
                if (left || owner == null || !owner.MeasuresForce)
                    continue;
                reactions.Get(i, out double3 sum, out double3 moment);
                var force = (Vector3)(float3)(sum * scale);
                var torque = (Vector3)(float3)(moment * (scale * particleSpacing * takenArms[i]));
                owner.SetForce(new FluidForce(this, takenRotation * force, takenRotation * torque, takenMotions[i]));
            }
        }
    }
}
