using System;
using System.Collections.Generic;
using Host.Output;
using Rill;

namespace Host
{
    /// <summary>Facts about Rill that the engine needs to play its scenes and run its tests.</summary>
    sealed class RillPackage : BuiltInPackage
    {
        public override IReadOnlyList<string> Assemblies { get; } = new[] { "Rill", "Rill.Physics", "Rill.Terrain",
            "Rill.TerrainPhysics", "Rill.Timeline", "Rill.Editor", "Rill.Samples", "Rill.Testing", "Rill.Physics.Editor", "Rill.Terrain.Editor",
            "Rill.TerrainPhysics.Editor" };

        public override IReadOnlyList<string> Tests { get; } = new[] { "Rill.Tests", "Rill.Physics.Tests", "Rill.Terrain.Tests",
            "Rill.TerrainPhysics.Tests", "Rill.Timeline.Tests", "Rill.Editor.Tests" };

        public override IReadOnlyList<string> ProgramTests { get; } = new[] { "Host.Tests" };

        // A suite that shrinks, or that no longer reaches the device, must not look well.
        public override (int All, int Dispatching) MinTestMethods => (800, 250);

        public override IDisposable Begin() => new EditorFind();

        public override void EnterPlayer() => StageShader.EditorFind = null;

        public override List<IRunProbe> Probes() => Probing.Probes.OfScene();

        public override string StateHash() => Probing.StateHash.OfScene();

        // Puts back how the editor finds stages.
        sealed class EditorFind : IDisposable
        {
            readonly Func<string, StageShader> before = StageShader.EditorFind;

            public void Dispose() => StageShader.EditorFind = before;
        }
    }
}
