using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>The buttons that simulate a fluid without Play, in its inspector and in the scene view.</summary>
    static class SceneSimulationControls
    {
        static readonly GUIContent simulate = new GUIContent("Simulate",
            "Runs this fluid without Play, with what acts on it and draws it. Nothing in the scene is changed."),
            pause = new GUIContent("Pause", "Its time stands still."),
            resume = new GUIContent("Go On", "Its time goes on."),
            step = new GUIContent("Step", "Pauses, and takes one fixed step."),
            restart = new GUIContent("Restart", "Begins again with the volumes or the start state."),
            speed = new GUIContent("Speed", "Fluid time that passes in a second, s: 1 is real time."),
            stop = new GUIContent("Stop", "Ends it: its particles are gone."),
            save = new GUIContent("Save as Start State",
                "Writes the present state into the asset of Start State, or into a new one that becomes the Start State.");

        /// <summary>Draws the problems, the running simulation and the buttons.</summary>
        public static void Draw(FluidSimulation fluid)
        {
            SceneSimulation current = SceneSimulation.Runs(fluid) ? SceneSimulation.Current : null;
            if (current == null && SceneSimulation.Problem != null)
                EditorGUILayout.HelpBox(SceneSimulation.Problem, MessageType.Warning);
            EditorGUILayout.BeginHorizontal();
            if (current == null)
            {
                if (GUILayout.Button(simulate))
                    SceneSimulation.Start(fluid);
            }
            else
                DrawRunning(current);
            EditorGUILayout.EndHorizontal();
            float chosen = EditorGUILayout.Slider(speed, SceneSimulation.Speed, SceneSimulation.MinSpeed, SceneSimulation.MaxSpeed);
            if (chosen != SceneSimulation.Speed)
                SceneSimulation.Speed = chosen;
            if (current == null)
                return;
            using (new EditorGUI.DisabledScope(current.IsSaving))
                if (GUILayout.Button(save))
                    current.SaveAsStart();
            EditorGUILayout.HelpBox(StateOf(current), MessageType.None);
        }

        internal static string StateOf(SceneSimulation simulation)
            => Invariant($"{(simulation.IsPaused ? "Paused" : "Simulated without Play")}: {simulation.Fluid.FluidTime:0.00} s, step ") +
            Invariant($"{simulation.Fluid.StepCount:N0}. Scripts and bodies do not move.");

        static void DrawRunning(SceneSimulation current)
        {
            if (GUILayout.Button(current.IsPaused ? resume : pause))
                current.IsPaused = !current.IsPaused;
            if (GUILayout.Button(step))
                current.Step();
            if (GUILayout.Button(restart))
                current.Restart();
            if (GUILayout.Button(stop))
                SceneSimulation.Stop();
        }
    }
}
