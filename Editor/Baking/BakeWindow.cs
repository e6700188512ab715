using System.Collections.Generic;
using System.Linq;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>Bakes the meshes of a selection to distance fields, after saying what is wrong with them and what it will take.</summary>
    sealed class BakeWindow : EditorWindow
    {
        const string Title = "Bake Signed Distance Field";

        [Tooltip("How the meshes are turned into distance fields.")]
        [SerializeField] MeshSdfSettings settings = MeshSdfSettings.Default;

        [Tooltip("Where new assets go, below Assets. A field that was baked from the same mesh there is baked in place.")]
        [SerializeField] string folder = "Assets/Distance Fields";

        [Tooltip("Use of the field: nothing, Fluid Colliders on the selected objects take it, or objects without one get a collider.")]
        [SerializeField] BakeAssign assign = BakeAssign.ToColliders;

        // Survives a reload of scripts.
        [SerializeField, HideInInspector] List<Object> chosen = new List<Object>();

        readonly MeshAnalyses analyses = new MeshAnalyses();
        BakePlan plan;
        FieldReceiver receiver;     // null where the window's own choice holds, and after a reload
        SerializedObject self;
        [System.NonSerialized] Vector2 scroll;

        [MenuItem("Window/Rill/" + Title)]
        static void OpenOnSelection() => Open(Selection.objects);

        [MenuItem("CONTEXT/MeshFilter/" + Title)]
        static void OpenOnFilter(MenuCommand command) => Open(new[] { command.context });

        [MenuItem("CONTEXT/Mesh/" + Title)]
        static void OpenOnMesh(MenuCommand command) => Open(new[] { command.context });

        [MenuItem("Assets/" + Title, true)]
        static bool SelectionHasMeshes() => Selection.objects.Any(o => o is Mesh || o is SignedDistanceField || o is GameObject root
            && root.GetComponentInChildren<MeshFilter>(true) != null);

        [MenuItem("Assets/" + Title)]
        static void OpenOnAssets() => Open(Selection.objects);

        /// <param name="receiver">Takes the fields, as long as nothing else is chosen; null for what the window says.</param>
        public static BakeWindow Open(IEnumerable<Object> objects, FieldReceiver receiver = null)
        {
            BakeWindow window = GetWindow<BakeWindow>(Title);
            window.Choose(objects, receiver);
            return window;
        }

        /// <summary>Null before anything was chosen.</summary>
        public BakePlan Plan => plan;

        /// <summary>Analyses of every mesh that was shown.</summary>
        public MeshAnalyses Analyses => analyses;

        /// <summary>Shows what there is to bake. Meshes that were not seen yet, or have changed, are analyzed from the next update on.</summary>
        /// <param name="receiver">Takes the fields; null for what the window says.</param>
        public void Choose(IEnumerable<Object> objects, FieldReceiver receiver = null)
        {
            this.receiver = receiver;
            chosen = objects.Where(o => o != null).ToList();
            plan = BakePlan.Of(chosen, folder, analyses);
            Repaint();
        }

        void OnEnable()
        {
            self = new SerializedObject(this);
            EditorApplication.update += Analyze;
            analyses.Resume();
            Choose(chosen.Count > 0 ? chosen : (IEnumerable<Object>)Selection.objects);
        }

        // Also before scripts are reloaded, which a thread should not outlive.
        void OnDisable()
        {
            EditorApplication.update -= Analyze;
            analyses.Pause();
            self.Dispose();
        }

        void OnSelectionChange()
        {
            analyses.Resume();
            Choose(Selection.objects);
        }

        void OnFocus() => Refresh();

        void OnProjectChange() => Refresh();

        // A mesh may have been edited, imported again or destroyed. Otherwise outcomes stay to be read.
        void Refresh()
        {
            if (plan.Items.Any(item => !item.Analysis.IsCurrent))
                Choose(chosen, receiver);
        }

        void Analyze()
        {
            if (analyses.Update(plan.Items.Select(item => item.Analysis)))
                Repaint();
        }

        void OnGUI()
        {
            // At each event no more than this: whether a mesh was imported again is asked when the window gets the focus.
            if (Event.current.type == EventType.Layout && plan.Items.Any(item => item.Mesh == null))
                Choose(chosen, receiver);
            self.Update();
            string before = folder;
            EditorGUILayout.PropertyField(self.FindProperty(nameof(settings)), true);
            EditorGUILayout.PropertyField(self.FindProperty(nameof(folder)));
            if (receiver == null)
                EditorGUILayout.PropertyField(self.FindProperty(nameof(assign)));
            else
                InspectorRows.Text("Assign", receiver.Label);
            // Settings change the estimates, which are drawn from the reports; only another folder makes other assets.
            if (self.ApplyModifiedProperties() && folder != before)
            {
                Choose(chosen, receiver);
                GUIUtility.ExitGUI();       // other rows than were laid out
            }
            DrawAnalysis();

            scroll = EditorGUILayout.BeginScrollView(scroll);
            if (chosen.Count == 0)
                EditorGUILayout.HelpBox("Select objects with Mesh Filters, meshes, or distance fields to bake again.", MessageType.Info);
            foreach (string note in plan.Notes)
                EditorGUILayout.HelpBox(note, MessageType.Warning);
            bool canBake = false;
            foreach (BakeItem item in plan.Items)
                canBake |= Draw(item);
            EditorGUILayout.EndScrollView();

            using (new EditorGUI.DisabledScope(!canBake))
                if (GUILayout.Button(plan.Items.Count == 1 ? "Bake" : Invariant($"Bake {plan.Items.Count} Meshes")))
                {
                    Bake();
                    GUIUtility.ExitGUI();       // the progress bar has ended this event's layout
                }
        }

        void DrawAnalysis()
        {
            int open = plan.Items.Count(item => !item.Analysis.IsDone);
            if (open > 0 && !analyses.IsPaused)
            {
                if (GUILayout.Button(Invariant($"Cancel Analysis ({open} to go)")))
                    analyses.Pause();
            }
            else if (GUILayout.Button(open > 0 ? "Analyze" : "Analyze Again"))
            {
                if (open == 0)
                    analyses.Clear();
                analyses.Resume();
                Choose(chosen, receiver);
                GUIUtility.ExitGUI();
            }
        }

        bool Draw(BakeItem item)
        {
            EditorGUILayout.Space();
            EditorGUILayout.LabelField(item.Mesh.name, EditorStyles.boldLabel);
            InspectorRows.Text(item.Existing != null ? "Baked in place" : "New asset", item.Path);
            if (!item.Analysis.IsDone)
            {
                (float fraction, string stage) = item.Analysis.Progress;
                EditorGUI.ProgressBar(EditorGUILayout.GetControlRect(), fraction, item.Analysis.IsRunning ? stage
                    : "Not analyzed yet: a bake does so first");
                return true;
            }
            bool canBake = item.TryEstimate(settings, out MeshSdfEstimate estimate, out string problem);
            if (item.Report != null)
            {
                InspectorRows.Text("Mesh", BakeTexts.Of(item.Report));
                foreach (string text in item.Report.Texts.Where(text => text != problem))
                    EditorGUILayout.HelpBox(text, MessageType.Info);
            }
            Draw(item.LossesOf(settings));
            if (canBake)
                InspectorRows.Text("Takes", BakeTexts.Of(estimate));
            else
                EditorGUILayout.HelpBox(problem, MessageType.Error);
            if (item.Outcome != null)
                EditorGUILayout.HelpBox(item.Outcome, item.Failed ? MessageType.Warning : MessageType.None);
            if (item.Field != null)
                EditorGUILayout.ObjectField("Field", item.Field, typeof(SignedDistanceField), false);
            return canBake;
        }

        void Draw(IReadOnlyList<MeshLoss> losses)
        {
            MeshSdfSettings with = settings;
            foreach (MeshLoss loss in losses)
            {
                EditorGUILayout.HelpBox(loss.Text, MessageType.Warning);
                if (loss.Remedy is MeshSdfSettings remedy && GUILayout.Button(BakeTexts.Of(remedy, with)))
                    settings = remedy;
            }
            if (!with.Equals(settings))
                GUIUtility.ExitGUI();       // other rows than were laid out
        }

        void Bake()
        {
            try
            {
                plan.Bake(settings, assign, (fraction, what) => !EditorUtility.DisplayCancelableProgressBar(Title, what, fraction), receiver);
            }
            finally
            {
                EditorUtility.ClearProgressBar();
            }
        }
    }
}
