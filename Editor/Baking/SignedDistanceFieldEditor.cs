using System;
using UnityEditor;
using UnityEngine;
using static System.FormattableString;

namespace Rill.Editor
{
    /// <summary>A field's facts, slices through it, its surface as a preview, and baking it again.</summary>
    [CustomEditor(typeof(SignedDistanceField))]
    sealed class SignedDistanceFieldEditor : UnityEditor.Editor
    {
        // Pixels. Tracing takes a tenth of a second at the larger one, so that a turning preview is smaller.
        const int SlicePixels = 256, PreviewPixels = 256, TurningPixels = 96;

        static readonly string[] Axes = { "x", "y", "z" };

        // With what is typed here they survive a reload of scripts.
        [SerializeField] MeshSdfSettings settings, baked;       // baked: with these, as far as is known here
        [SerializeField] int axis = 2;
        [SerializeField] Vector2 turn = new Vector2(30f, 20f);

        SerializedObject self;
        readonly int[] layers = new int[3];
        readonly FieldPicture slice = new FieldPicture("Slice"), surface = new FieldPicture("Surface");
        SdfVolume volume;
        [NonSerialized] Mesh mesh;
        [NonSerialized] string problem, staleness, outcome;
        [NonSerialized] bool isTurning;

        SignedDistanceField Field => (SignedDistanceField)target;

        void OnEnable()
        {
            self = new SerializedObject(this);
            Undo.undoRedoPerformed += Follow;
            Adopt();
            Look();
            for (int i = 0; i < layers.Length; i++)
                layers[i] = volume != null ? volume.Resolution[i] / 2 : 0;
        }

        void OnDisable()
        {
            Undo.undoRedoPerformed -= Follow;
            self.Dispose();
            slice.Release();
            surface.Release();
        }

        // An undo may have brought back an earlier bake, or only what was typed here.
        void Follow()
        {
            if (target == null)
                return;
            Adopt();
            Look();
        }

        // The settings of a bake that is not known here.
        void Adopt()
        {
            if (!baked.Equals(Field.Settings))
                settings = baked = Field.Settings;
        }

        // Reads again what a bake, by this inspector or the window, may have changed.
        void Look()
        {
            volume = SdfVolume.Of(Field, out problem);
            mesh = FieldAssets.MeshOf(Field, out staleness);
            if (mesh != null && Field.IsStale(EditorMesh.Read(mesh)))
                staleness = $"'{mesh.name}' has changed since it was baked: bake it again.";
            slice.Invalidate();
            surface.Invalidate();
        }

        public override void OnInspectorGUI()
        {
            if (problem != null)
                EditorGUILayout.HelpBox(problem, MessageType.Error);
            foreach ((string label, string text) in BakeTexts.Facts(Field))
                InspectorRows.Text(label, text);
            if (staleness != null)
                EditorGUILayout.HelpBox(staleness, MessageType.Warning);

            DrawSlice();
            DrawBake();
        }

        void DrawSlice()
        {
            if (volume == null)
                return;
            EditorGUILayout.Space();
            axis = EditorGUILayout.Popup("Slice Across", axis, Axes);
            SdfSlice view = SdfSlice.Across(axis);
            layers[axis] = EditorGUILayout.IntSlider(new GUIContent("Layer", "Voxels from the lower end."),
                Mathf.Clamp(layers[axis], 0, volume.Resolution[axis] - 1), 0, volume.Resolution[axis] - 1);
            int layer = layers[axis];
            float range = Mathf.Max(view.MaxDistance(volume, layer), volume.VoxelSize);
            InspectorRows.Text(" ",
                Invariant($"{Axes[axis]} = {view.PositionOf(volume, layer):G4} m; blue inside to {-range:G3} m, orange outside to ") +
                Invariant($"{range:G3} m"));
            Vector2Int size = view.SizeOf(volume, SlicePixels);
            Texture2D picture = slice.Of((axis, layer), size, pixels => view.Paint(volume, layer, range, size, pixels));
            EditorGUI.DrawPreviewTexture(GUILayoutUtility.GetAspectRect((float)size.x / size.y, GUILayout.MaxWidth(2 * SlicePixels)), picture);
        }

        void DrawBake()
        {
            EditorGUILayout.Space();
            mesh = (Mesh)EditorGUILayout.ObjectField("Mesh", mesh, typeof(Mesh), false);
            self.Update();
            EditorGUILayout.PropertyField(self.FindProperty(nameof(settings)), true);
            self.ApplyModifiedProperties();
            using (new EditorGUI.DisabledScope(mesh == null))
                if (GUILayout.Button("Bake Again"))
                {
                    Bake();
                    GUIUtility.ExitGUI();       // the progress bar has ended this event's layout
                }
            if (outcome != null)
                EditorGUILayout.HelpBox(outcome, MessageType.Info);
        }

        void Bake()
        {
            var item = new BakeItem(new MeshAnalysis(mesh), AssetDatabase.GetAssetPath(Field), Field);
            try
            {
                item.Bake(settings, (fraction, stage) => !EditorUtility.DisplayCancelableProgressBar("Bake Signed Distance Field",
                    $"{mesh.name}: {stage}", fraction));
            }
            finally
            {
                EditorUtility.ClearProgressBar();
            }
            outcome = item.Outcome;
            foreach (MeshLoss loss in item.LossesOf(settings))
                outcome += "\n" + loss.Text;
            baked = Field.Settings;
            Look();
        }

        public override bool HasPreviewGUI() => volume != null;

        public override GUIContent GetPreviewTitle() => new GUIContent(Field.name);

        public override void OnPreviewGUI(Rect area, GUIStyle background)
        {
            Turn(area);
            int pixels = isTurning ? TurningPixels : PreviewPixels;
            var size = new Vector2Int(pixels, pixels);
            Texture2D picture = surface.Of((turn, pixels), size, target => SdfTrace.Paint(volume, turn.x, turn.y, size, target));
            float side = Mathf.Min(area.width, area.height);
            EditorGUI.DrawPreviewTexture(new Rect(area.center.x - 0.5f * side, area.center.y - 0.5f * side, side, side), picture);
        }

        void Turn(Rect area)
        {
            Event now = Event.current;
            int id = GUIUtility.GetControlID(FocusType.Passive);
            switch (now?.GetTypeForControl(id))
            {
                case EventType.MouseDown when area.Contains(now.mousePosition):
                    GUIUtility.hotControl = id;
                    isTurning = true;
                    now.Use();
                    break;
                case EventType.MouseDrag when GUIUtility.hotControl == id:
                    turn = new Vector2(turn.x + now.delta.x, Mathf.Clamp(turn.y + now.delta.y, -90f, 90f));
                    now.Use();
                    break;
                case EventType.MouseUp when GUIUtility.hotControl == id:
                    GUIUtility.hotControl = 0;
                    isTurning = false;
                    now.Use();
                    break;
            }
        }
    }
}
