using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>Snapshots of fluids that play, as assets.</summary>
    static class SnapshotAssets
    {
        /// <summary>Writes a snapshot into the fluid's start state, so that references stay, or into a new asset where it has none.</summary>
        /// <returns>The asset's path.</returns>
        public static string Save(FluidSimulation simulation, FluidSnapshot snapshot)
        {
            FluidSnapshotAsset asset = simulation.StartState;
            string path = asset != null ? AssetDatabase.GetAssetPath(asset) : "";
            if (path == "")
                path = AssetDatabase.GenerateUniqueAssetPath($"Assets/{FieldAssets.FileName(simulation.name)} Start State.asset");
            Write(asset, snapshot, path);
            return path;
        }

        // Into an asset, so that references to it stay, or without one into a new one at the path.
        static FluidSnapshotAsset Write(FluidSnapshotAsset asset, FluidSnapshot snapshot, string path)
        {
            if (asset == null)
            {
                asset = FluidSnapshotAsset.Create(snapshot);
                AssetDatabase.CreateAsset(asset, path);
                return asset;
            }
            asset.Apply(snapshot);
            EditorUtility.SetDirty(asset);
            AssetDatabase.SaveAssetIfDirty(asset);
            return asset;
        }

        /// <summary>Saves a snapshot that has come and has the fluid start with it, outside play mode. Where the fluid has no start state,
        /// asks for the file first. Undo takes the start state back, and the file stays.</summary>
        public static void SaveAsStart(FluidSimulation simulation, FluidSnapshotRequest done)
        {
            if (done.Snapshot == null)
            {
                LogProblem(simulation, done);
                return;
            }
            string path = AssetDatabase.GetAssetPath(simulation.StartState);
            if (path == "")
                path = ChoosePath(simulation);
            if (path != "")
                SaveAsStart(simulation, done.Snapshot, path);
        }

        /// <param name="path">Path in the project; a snapshot that is there is replaced, and references to it stay.</param>
        internal static void SaveAsStart(FluidSimulation simulation, FluidSnapshot snapshot, string path)
        {
            FluidSnapshotAsset asset = Write(AssetDatabase.LoadAssetAtPath<FluidSnapshotAsset>(path), snapshot, path);
            using (var stored = new SerializedObject(simulation))
            {
                stored.FindProperty("startState").objectReferenceValue = asset;
                stored.ApplyModifiedProperties();
            }
            Debug.Log(Invariant($"Rill: '{simulation.name}' starts with '{path}': {snapshot.ParticleCount:N0} particles."), simulation);
        }

        static string ChoosePath(FluidSimulation simulation) => EditorUtility.SaveFilePanelInProject("Save as Start State",
            FieldAssets.FileName(simulation.name) + " Start State", "asset", "Where to keep the state that this fluid starts with.");

        /// <summary>The button of an inspector: asks for a snapshot and saves it when it has come.</summary>
        /// <param name="request">Pending; null for none.</param>
        public static void Draw(FluidSimulation simulation, ref FluidSnapshotRequest request)
        {
            using (new EditorGUI.DisabledScope(request != null || !simulation.IsRunning))
                if (GUILayout.Button(new GUIContent("Save as Start State",
                    "Writes the present state into the asset of Start State, or into a new one in Assets.")))
                    request = simulation.RequestSnapshot();
            if (request == null || !request.IsDone || Event.current.type != EventType.Layout)
                return;
            if (request.Snapshot != null)
                Debug.Log($"Rill: the state of '{simulation.name}' is in '{Save(simulation, request.Snapshot)}': " +
                    Invariant($"{request.Snapshot.ParticleCount:N0} particles. After play, assign it to Start State."), simulation);
            else
                LogProblem(simulation, request);
            request = null;
        }

        static void LogProblem(FluidSimulation simulation, FluidSnapshotRequest done)
            => Debug.LogError($"Rill: the state of '{simulation.name}' was not saved: {done.Problem}", simulation);
    }
}
