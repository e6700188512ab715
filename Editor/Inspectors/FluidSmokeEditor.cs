using System.Collections.Generic;
using UnityEditor;
using static System.FormattableString;

namespace Rill.Editor
{
    [CustomEditor(typeof(FluidSmoke))]
    [CanEditMultipleObjects]
    sealed class FluidSmokeEditor : FluidRendererEditor
    {
        static readonly InspectorSection[] AllSections =
        {
            new InspectorSection("Air", true,
                new InspectorField("settings.airTemperature", "°C"),
                new InspectorField("settings.openSides"),
                new InspectorField("settings.vorticity", "1/s"),
                new InspectorField("settings.cellSize", "m")),
            new InspectorSection("Smoke", true,
                new InspectorField("settings.lifetime", "s"),
                new InspectorField("settings.cooling", "s"),
                new InspectorField("settings.steam", "1/m"),
                new InspectorField("settings.steamTemperature", "°C")),
            new InspectorSection("Look", true,
                new InspectorField("color"),
                new InspectorField("glow"),
                new InspectorField("sun"),
                new InspectorField("ambient")),
            Shadows,
        };

        internal override InspectorSection[] Sections => AllSections;

        internal override void ListLive(List<(string label, string text)> live)
        {
            var simulation = ((FluidSmoke)target).GetComponent<FluidSimulation>();
            if (simulation.Solver?.Smoke is Smoke smoke)
                live.Add(("Grid", Invariant($"{smoke.Counts.x} x {smoke.Counts.y} x {smoke.Counts.z} cells of ") +
                    Invariant($"{smoke.CellSize.x * simulation.ParticleSpacing:0.###} m")));
        }
    }
}
