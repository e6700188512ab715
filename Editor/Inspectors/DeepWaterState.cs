using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.SceneManagement;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>Whether a fluid solves for the pressure of deep water, and why: before it plays by its volumes and emitters.</summary>
    static class DeepWaterState
    {
        /// <summary>One line of an inspector.</summary>
        public static string Describe(FluidSimulation fluid)
        {
            DeepWater mode = fluid.Settings.deepWater;
            if (mode == DeepWater.Automatic && !fluid.IsRunning && fluid.StartState != null)
                return "by the depth of the Start State, when it plays";
            bool isPresent = fluid.IsRunning && fluid.Solver.Coarse != null;
            if (mode != DeepWater.Off && fluid.IsRunning && fluid.StepCount > 0 && fluid.Input.settings.deepWater == DeepWater.Off)
                return "off: this device or build does without, see the Console";
            float layers = Layers(fluid);
            var input = new StepInput { settings = fluid.Settings, material = fluid.Material };
            if (fluid.IsRunning)
                input.phases = fluid.Input.phases;
            string text = (CoarseCorrection.IsNeeded(input, layers, isPresent) ? "on: " : "off: ") +
                CoarseCorrection.Reason(input, layers, isPresent);
            return mode == DeepWater.Automatic ? text : text + Invariant($", water {layers:0} layers deep");
        }

        /// <summary>Why bodies in a fluid sink; null where they do not.</summary>
        public static string FloatingProblem(FluidSimulation fluid)
        {
            if (fluid.Settings.deepWater != DeepWater.Off || !IsDeep(fluid))
                return null;
            return Invariant($"Deep Water of '{fluid.name}' is off, and its water can be {Layers(fluid):0} layers deep. Above ") +
                Invariant($"{CoarseCorrection.MaxLayersWithout:0} layers water collapses without it, and bodies sink to about twice their ") +
                "draft. Set Deep Water to Automatic.";
        }

        /// <summary>Lists the same for all fluids of the open scenes near whose box an object is.</summary>
        public static IEnumerable<string> FloatingProblems(GameObject body)
        {
            for (int i = 0; i < SceneManager.sceneCount; i++)
                foreach (GameObject root in SceneManager.GetSceneAt(i).GetRootGameObjects())
                    foreach (FluidSimulation fluid in root.GetComponentsInChildren<FluidSimulation>(true))
                        if (IsNear(fluid, body.transform.position) && FloatingProblem(fluid) is string problem)
                            yield return problem;
        }

        /// <summary>How deep the water can be along gravity, d.</summary>
        public static float Layers(FluidSimulation fluid)
        {
            fluid.GetPose(out Vector3 position, out Quaternion rotation);
            Vector3 gravity = Quaternion.Inverse(rotation) * fluid.Gravity;
            if (fluid.IsRunning)
                return fluid.Solver.WaterDepth(gravity);
            if (!(fluid.ParticleSpacing > 0f) || !(gravity.sqrMagnitude > 0f))
                return 0f;

            Matrix4x4 toBox = Matrix4x4.TRS(position, rotation, Vector3.one).inverse;
            bool isThere = false;
            Bounds water = default;
            foreach (FluidVolume volume in fluid.GetComponentsInChildren<FluidVolume>())
                if (TryGet(volume, out Bounds own, out Matrix4x4 toWorld))
                    FrameBounds.Join(ref isThere, ref water, FrameBounds.Turned(toBox * toWorld, own));
            Vector3 down = fluid.DomainSize.magnitude * gravity.normalized;
            foreach (FluidEmitter emitter in MissingPart.EmittersOf(fluid))
            {
                if (!emitter.isActiveAndEnabled || !FrameBounds.TryGet(emitter, out Bounds outlet))
                    continue;
                Bounds reach = FrameBounds.Turned(toBox, outlet);
                reach.size = 2f * Mathf.Max(reach.extents.x, reach.extents.y, reach.extents.z) * Vector3.one;      // as the solver takes it
                FrameBounds.Join(ref isThere, ref water, reach);
                FrameBounds.Join(ref isThere, ref water, new Bounds(reach.center + down, reach.size));
            }
            if (!isThere)
                return 0f;
            Vector3 half = 0.5f * fluid.DomainSize;
            float3 extent = math.max(math.min(water.max, half) - math.max(water.min, -half), 0f);
            return math.dot(math.abs((float3)gravity.normalized), extent) / fluid.ParticleSpacing;
        }

        static bool IsDeep(FluidSimulation fluid) => math.round(Layers(fluid)) > CoarseCorrection.MaxLayersWithout;

        // Within a box's size of it: a body may begin above its lid.
        static bool IsNear(FluidSimulation fluid, Vector3 position)
        {
            if (!FrameBounds.TryGet(fluid, out Bounds box))
                return false;
            box.Expand(2f * box.size);
            return box.Contains(position);
        }

        // In the volume's own frame.
        static bool TryGet(FluidVolume volume, out Bounds own, out Matrix4x4 toWorld)
        {
            Transform at = volume.transform;
            bool isField = volume.Shape == VolumeShape.SignedDistanceField;
            own = isField ? volume.Field != null ? volume.Field.Bounds : default : new Bounds(Vector3.zero,
                volume.Shape == VolumeShape.Sphere ? 2f * volume.Radius * Vector3.one : volume.Size);
            toWorld = Matrix4x4.TRS(at.position, at.rotation, isField ? at.lossyScale : Vector3.one);
            return Limit.IsPose(at.position, at.rotation) && (!isField || volume.Field != null);
        }
    }
}
