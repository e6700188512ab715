using UnityEditor;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>The simulation's settings and, while it runs, its newest measurements.</summary>
    [CustomEditor(typeof(FluidSimulation))]
    sealed class FluidSimulationEditor : UnityEditor.Editor
    {
        public override bool RequiresConstantRepaint() => Application.isPlaying;

        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();

            var simulation = (FluidSimulation)target;
            EditorGUILayout.Space();
            BudgetState state = simulation.BudgetState;
            foreach ((string label, string text) in BudgetSummary.Rows(state))
                EditorGUILayout.LabelField(label, text);
            foreach ((MessageType type, string text) in BudgetSummary.Messages(simulation.Budget, state, simulation.StatisticsInterval))
                EditorGUILayout.HelpBox(text, type);
            if (!Application.isPlaying)
                EditorGUILayout.HelpBox("Measurements appear here in play mode.", MessageType.None);
            else if (simulation.TryGetStatistics(out FluidStatistics statistics))
                Show(statistics);
            else
                EditorGUILayout.HelpBox(simulation.StatisticsInterval == 0 ? "The statistics interval is 0: nothing is measured." : "No measurement has come back yet.", MessageType.None);
        }

        static void Show(in FluidStatistics statistics)
        {
            EditorGUILayout.LabelField("Time", $"{statistics.time:F2} s, step {statistics.step:N0}");
            EditorGUILayout.LabelField("Particles", $"{statistics.particles:N0}, refused {statistics.refused:N0}, not finite {statistics.nonFinite:N0}");
            EditorGUILayout.LabelField("Density error", $"mean {statistics.densityError:P2}, 99.9 % below {statistics.densityError999:P1}, most {statistics.densityErrorMax:P0}");
            EditorGUILayout.LabelField("Volume", $"{statistics.volumeRatio:F3} of rest");
            EditorGUILayout.LabelField("Speed", $"rms {statistics.speed:F2}, jitter {statistics.jitter:F3}, most {statistics.speedMax:F2} m/s");
            EditorGUILayout.LabelField("Energy", $"{statistics.Energy:G4} J");
            EditorGUILayout.LabelField("Relaxation", statistics.relaxationClamped ? $"{statistics.relaxation} (clamped)" : $"{statistics.relaxation}");
            if (statistics.neighborOverflow > 0)
                EditorGUILayout.HelpBox($"{statistics.neighborOverflow:N0} particles had more neighbors than their list holds (up to {statistics.mostNeighbors}). Raise the neighbor capacity.", MessageType.Warning);
            if (statistics.refused > 0)
                EditorGUILayout.HelpBox($"{statistics.refused:N0} particles did not fit. Raise the capacity.", MessageType.Warning);
        }
    }
}
