using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Something without which a fluid is not seen or not there, and what adds it.</summary>
    sealed class MissingPart
    {
        MissingPart(string text, string button, Action add) => (Text, Button, Add) = (text, button, add);

        /// <summary>Missing part and its consequence, in a sentence or two.</summary>
        public string Text { get; }

        /// <summary>Label of the button; null where it cannot be added here.</summary>
        public string Button { get; }

        /// <summary>Adds it, with undo.</summary>
        public Action Add { get; }

        /// <summary>Lists the parts that a fluid needs and lacks.</summary>
        public static List<MissingPart> Of(FluidSimulation fluid)
        {
            var missing = new List<MissingPart>();
            if (!HasRenderer(fluid))
                missing.Add(new MissingPart("Nothing draws this fluid.", "Add Fluid Surface", () => SceneSetup.AddRenderer(fluid)));
            if (!HasSource(fluid))
                // A child cannot be put below the object of a prefab that is not open.
                missing.Add(EditorUtility.IsPersistent(fluid)
                    ? new MissingPart("No Fluid Volume or Fluid Emitter fills this fluid. Open the prefab to add one.", null, null)
                    : new MissingPart(
                        "No Fluid Volume or Fluid Emitter fills this fluid: it starts empty and stays so, unless a script adds particles.",
                        "Add Fluid Volume", () => SceneSetup.AddVolume(fluid)));
            return missing;
        }

        // The box and the foam alone show no fluid.
        static bool HasRenderer(FluidSimulation fluid)
        {
            foreach (FluidRenderer renderer in fluid.GetComponents<FluidRenderer>())
                if (!(renderer is DomainRenderer) && !(renderer is FluidFoam))
                    return true;
            return fluid.GetComponent<FluidSurfaceMesh>() != null;
        }

        static bool HasSource(FluidSimulation fluid)
        {
            if (fluid.GetComponentInChildren<FluidVolume>(true) != null)
                return true;
            foreach (FluidEmitter _ in EmittersOf(fluid))
                return true;
            return false;
        }

        /// <summary>Emitters that act on a fluid, wherever in its scene they are.</summary>
        public static IEnumerable<FluidEmitter> EmittersOf(FluidSimulation fluid)
        {
            foreach (FluidEmitter emitter in Emitters(fluid))
                if (FluidOf(emitter) == fluid)
                    yield return emitter;
        }

        static IEnumerable<FluidEmitter> Emitters(FluidSimulation fluid)
        {
            if (EditorUtility.IsPersistent(fluid))
                return fluid.transform.root.GetComponentsInChildren<FluidEmitter>(true);
            // Also those of other objects, which refer to it.
            var emitters = new List<FluidEmitter>();
            foreach (GameObject root in fluid.gameObject.scene.GetRootGameObjects())
                emitters.AddRange(root.GetComponentsInChildren<FluidEmitter>(true));
            return emitters;
        }

        /// <summary>Fluid that an emitter acts on; null for none.</summary>
        // The property is known only while it is enabled in play mode.
        public static FluidSimulation FluidOf(FluidEmitter emitter)
        {
            if (emitter.Simulation != null)
                return emitter.Simulation;
            using (var serialized = new SerializedObject(emitter))
            {
                var chosen = serialized.FindProperty("simulation").objectReferenceValue as FluidSimulation;
                return chosen != null ? chosen : emitter.GetComponentInParent<FluidSimulation>(true);
            }
        }
    }
}
