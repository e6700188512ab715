using System;
using System.Collections.Generic;
using System.IO;
using UnityEditor;

namespace Rill.Editor
{
    /// <summary>Opens the page of the manual about a component, from its context menu. The manual comes with the package, so that it is
    /// that of the version in use.</summary>
    static class ManualPages
    {
        public const string Folder = PackagePaths.Root + "Documentation~/";

        const string Item = "/Open Manual Page";

        // By name: some are in assemblies that a project may be without.
        static readonly Dictionary<string, string> Pages = new Dictionary<string, string>
        {
            { "DomainRenderer", "rendering.md" },
            { "FluidBoneColliders", "colliders.md" },
            { "FluidBuoyancy", "floating.md" },
            { "FluidCollider", "colliders.md" },
            { "FluidConnection", "control.md" },
            { "FluidDeformingMesh", "colliders.md" },
            { "FluidDetector", "queries.md" },
            { "FluidDrain", "sources.md" },
            { "FluidEmitter", "sources.md" },
            { "FluidFoam", "foam.md" },
            { "FluidFollow", "control.md" },
            { "FluidForceField", "sources.md" },
            { "FluidPhysicsColliders", "colliders.md" },
            { "FluidPlayback", "state.md" },
            { "FluidProbe", "queries.md" },
            { "FluidRecorder", "state.md" },
            { "FluidSimulation", "running.md" },
            { "FluidSnapshotAsset", "state.md" },
            { "FluidSurface", "surface.md" },
            { "FluidTerrain", "colliders.md" },
            { "FluidVolume", "sources.md" },
            { "ParticleRenderer", "rendering.md" },
            { "SignedDistanceField", "baking.md" },
        };

        /// <summary>File in <see cref="Folder"/>; null for what has no page.</summary>
        public static string PageOf(Type type) => Pages.TryGetValue(type.Name, out string page) ? page : null;

        [MenuItem("CONTEXT/DomainRenderer" + Item)]
        [MenuItem("CONTEXT/FluidBoneColliders" + Item)]
        [MenuItem("CONTEXT/FluidBuoyancy" + Item)]
        [MenuItem("CONTEXT/FluidCollider" + Item)]
        [MenuItem("CONTEXT/FluidConnection" + Item)]
        [MenuItem("CONTEXT/FluidDeformingMesh" + Item)]
        [MenuItem("CONTEXT/FluidDetector" + Item)]
        [MenuItem("CONTEXT/FluidDrain" + Item)]
        [MenuItem("CONTEXT/FluidEmitter" + Item)]
        [MenuItem("CONTEXT/FluidFoam" + Item)]
        [MenuItem("CONTEXT/FluidFollow" + Item)]
        [MenuItem("CONTEXT/FluidForceField" + Item)]
        [MenuItem("CONTEXT/FluidPhysicsColliders" + Item)]
        [MenuItem("CONTEXT/FluidPlayback" + Item)]
        [MenuItem("CONTEXT/FluidProbe" + Item)]
        [MenuItem("CONTEXT/FluidRecorder" + Item)]
        [MenuItem("CONTEXT/FluidSimulation" + Item)]
        [MenuItem("CONTEXT/FluidSnapshotAsset" + Item)]
        [MenuItem("CONTEXT/FluidSurface" + Item)]
        [MenuItem("CONTEXT/FluidTerrain" + Item)]
        [MenuItem("CONTEXT/FluidVolume" + Item)]
        [MenuItem("CONTEXT/ParticleRenderer" + Item)]
        [MenuItem("CONTEXT/SignedDistanceField" + Item)]
        static void Open(MenuCommand command)
            => EditorUtility.OpenWithDefaultApp(Path.GetFullPath(Folder + PageOf(command.context.GetType())));
    }
}
