using System.Collections.Generic;
using UnityEditor;
using UnityEditor.Overlays;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>The buttons in the scene view: of the fluid that is simulated, else of the selected one.</summary>
    [Overlay(typeof(SceneView), "rill-fluid", "Fluid", true)]
    sealed class FluidOverlay : IMGUIOverlay, ITransientOverlay
    {
        List<MissingPart> missing = new List<MissingPart>();

        public bool visible => Target != null;

        static FluidSimulation Target
        {
            get
            {
                if (Application.isPlaying)
                    return null;
                if (SceneSimulation.Current != null && SceneSimulation.Current.Fluid != null)
                    return SceneSimulation.Current.Fluid;
                GameObject selected = Selection.activeGameObject;
                bool isInScene = selected != null && !EditorUtility.IsPersistent(selected);
                return isInScene ? selected.GetComponentInParent<FluidSimulation>(true) : null;
            }
        }

        public override void OnGUI()
        {
            FluidSimulation target = Target;
            if (target == null)
                return;
            GUILayout.Label(target.name, EditorStyles.boldLabel);
            // Both passes of a frame have to draw the same rows.
            if (Event.current.type == EventType.Layout)
                missing = MissingPart.Of(target);
            foreach (MissingPart part in missing)
                EditorGUILayout.HelpBox(part.Text, MessageType.Info);
            SceneSimulationControls.Draw(target);
        }
    }
}
