using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;

namespace Host.Check.Api
{
    /// <summary>A method that Unity calls by its name.</summary>
    /// <param name="Receiver">The class whose heirs it is sent to.</param>
    /// <param name="Optional">Whether the method may do without its parameters.</param>
    sealed record UnityMessage(string Receiver, string Name, bool IsStatic, IReadOnlyList<string> Returns, IReadOnlyList<string> Parameters,
    bool Optional)
    {
        public override string ToString() =>
            $"{(IsStatic ? "static " : "")}{string.Join(" or ", Returns)} {Name}({string.Join(", ", Parameters)})";
    }

    /// <summary>
    /// The messages of the classes that scripts derive from, as the pages of Unity's Scripting API list them (2022.3 and 6000.0: MonoBehaviour,
    /// ScriptableObject, Editor, EditorWindow, AssetPostprocessor, AssetModificationProcessor). What a class has as a virtual method is not one.
    /// </summary>
    static class UnityMessages
    {
        // "returns name(parameters)"; nothing before the name: void; "routine": void or IEnumerator; "?" after the list: it may be left out.
        static readonly (string Receiver, string[] Forms)[] Forms =
        {
            ("UnityEngine.MonoBehaviour", new[]
            {
                "Awake()", "FixedUpdate()", "LateUpdate()", "Update()", "OnEnable()", "OnDisable()", "OnDestroy()", "OnValidate()", "OnGUI()",
                "OnDrawGizmos()", "OnDrawGizmosSelected()", "OnRenderObject()", "OnPreCull()", "OnPreRender()", "OnPostRender()",
                "routine|UnityEngine.Awaitable Start()", "routine Reset()", "routine OnApplicationFocus(bool)?", "routine OnApplicationPause(bool)?",
                "routine OnApplicationQuit()", "routine OnBecameInvisible()", "routine OnBecameVisible()", "routine OnWillRenderObject()",
                "routine OnRenderImage(UnityEngine.RenderTexture, UnityEngine.RenderTexture)", "routine OnLevelWasLoaded(int)",
                "routine OnCollisionEnter(UnityEngine.Collision)?", "routine OnCollisionExit(UnityEngine.Collision)?",
                "routine OnCollisionStay(UnityEngine.Collision)?", "routine OnCollisionEnter2D(UnityEngine.Collision2D)?",
                "routine OnCollisionExit2D(UnityEngine.Collision2D)?", "routine OnCollisionStay2D(UnityEngine.Collision2D)?",
                "routine OnTriggerEnter(UnityEngine.Collider)?", "routine OnTriggerExit(UnityEngine.Collider)?",
                "routine OnTriggerStay(UnityEngine.Collider)?", "routine OnTriggerEnter2D(UnityEngine.Collider2D)?",
                "routine OnTriggerExit2D(UnityEngine.Collider2D)?", "routine OnTriggerStay2D(UnityEngine.Collider2D)?",
                "routine OnControllerColliderHit(UnityEngine.ControllerColliderHit)?", "routine OnJointBreak(float)?",
                "routine OnJointBreak2D(UnityEngine.Joint2D)?", "routine OnParticleCollision(UnityEngine.GameObject)?",
                "routine OnParticleTrigger()", "routine OnParticleSystemStopped()",
                "routine OnParticleUpdateJobScheduled(UnityEngine.ParticleSystemJobs.ParticleSystemJobData)?",
                "routine OnMouseDown()", "routine OnMouseDrag()", "routine OnMouseEnter()", "routine OnMouseExit()", "routine OnMouseOver()",
                "routine OnMouseUp()", "routine OnMouseUpAsButton()", "routine OnAnimatorIK(int)?", "routine OnAnimatorMove()",
                "OnAudioFilterRead(float[], int)", "routine OnTransformChildrenChanged()", "routine OnTransformParentChanged()",
                "routine OnBeforeTransformParentChanged()", "routine OnRectTransformDimensionsChange()", "routine OnCanvasGroupChanged()",
                "routine OnCanvasHierarchyChanged()", "routine OnDidApplyAnimationProperties()", "routine OnServerInitialized()",
                "routine OnConnectedToServer()",
            }),
            ("UnityEngine.ScriptableObject", new[] { "Awake()", "OnEnable()", "OnDisable()", "OnDestroy()", "OnValidate()", "Reset()" }),
            ("UnityEditor.Editor", new[]
            {
                "OnSceneGUI()", "bool HasFrameBounds()", "UnityEngine.Bounds OnGetFrameBounds()", "OnSceneDrag(UnityEditor.SceneView, int)",
            }),
            ("UnityEditor.EditorWindow", new[]
            {
                "CreateGUI()", "OnGUI()", "Update()", "OnFocus()", "OnLostFocus()", "OnHierarchyChange()", "OnInspectorUpdate()",
                "OnProjectChange()", "OnSelectionChange()", "OnBecameVisible()", "OnBecameInvisible()", "OnMainWindowMove()",
                "OnDidOpenScene()", "OnAddedAsTab()", "OnTabDetached()", "ModifierKeysChanged()", "ShowButton(UnityEngine.Rect)",
            }),
            ("UnityEditor.AssetPostprocessor", new[]
            {
                "OnPreprocessAsset()", "OnPreprocessAnimation()", "OnPreprocessAudio()",
                    "OnPreprocessCameraDescription(UnityEditor.AssetImporters.CameraDescription, UnityEngine.Camera, UnityEngine.AnimationClip[])",
                "OnPreprocessLightDescription(UnityEditor.AssetImporters.LightDescription, UnityEngine.Light, UnityEngine.AnimationClip[])",
                "OnPreprocessMaterialDescription(UnityEditor.AssetImporters.MaterialDescription, UnityEngine.Material, UnityEngine.AnimationClip[])",
                "OnPreprocessModel()", "OnPreprocessSpeedTree()", "OnPreprocessTexture()",
                "UnityEngine.Material OnAssignMaterialModel(UnityEngine.Material, UnityEngine.Renderer)",
                "OnPostprocessAnimation(UnityEngine.GameObject, UnityEngine.AnimationClip)",
                "OnPostprocessAssetbundleNameChanged(string, string, string)", "OnPostprocessAudio(UnityEngine.AudioClip)",
                "OnPostprocessCubemap(UnityEngine.Cubemap)",
                "OnPostprocessGameObjectWithAnimatedUserProperties(UnityEngine.GameObject, UnityEditor.EditorCurveBinding[])",
                "OnPostprocessGameObjectWithUserProperties(UnityEngine.GameObject, string[], object[])",
                "OnPostprocessMaterial(UnityEngine.Material)", "OnPostprocessMeshHierarchy(UnityEngine.GameObject)",
                "OnPostprocessModel(UnityEngine.GameObject)", "OnPostprocessPrefab(UnityEngine.GameObject)",
                "OnPostprocessSpeedTree(UnityEngine.GameObject)", "OnPostprocessSprites(UnityEngine.Texture2D, UnityEngine.Sprite[])",
                "OnPostprocessTexture(UnityEngine.Texture2D)", "OnPostprocessTexture2DArray(UnityEngine.Texture2DArray)",
                "OnPostprocessTexture3D(UnityEngine.Texture3D)",
                "static OnPostprocessAllAssets(string[], string[], string[], string[])",
                "static OnPostprocessAllAssets(string[], string[], string[], string[], bool)",
                "static string OnGeneratedCSProject(string, string)", "static string OnGeneratedSlnSolution(string, string)",
                "static OnGeneratedCSProjectFiles()", "static bool OnPreGeneratingCSProjectFiles()",
            }),
            ("UnityEditor.AssetModificationProcessor", new[]
            {
                "static OnWillCreateAsset(string)", "static string[]|void OnWillSaveAssets(string[])",
                "static UnityEditor.AssetDeleteResult OnWillDeleteAsset(string, UnityEditor.RemoveAssetOptions)",
                "static UnityEditor.AssetMoveResult OnWillMoveAsset(string, string)", "static OnStatusUpdated()",
                "static FileModeChanged(string[], UnityEditor.VersionControl.FileMode)",
                "static bool CanOpenForEdit(string[], System.Collections.Generic.List<string>, UnityEditor.StatusQueryOptions)",
                "static bool IsOpenForEdit(string[], System.Collections.Generic.List<string>, UnityEditor.StatusQueryOptions)",
                "static bool MakeEditable(string[], string, System.Collections.Generic.List<string>)",
            }),
        };

        static readonly Regex Form = new(@"^(static )?(?:(\S+) )?(\w+)\((.*)\)(\?)?$");

        public static IReadOnlyList<UnityMessage> All { get; } =
            Forms.SelectMany(receiver => receiver.Forms.Select(form => Read(receiver.Receiver, form))).ToList();

        static UnityMessage Read(string receiver, string form)
        {
            Match match = Form.Match(form);
            string[] returns = match.Groups[2].Value.Split('|', StringSplitOptions.RemoveEmptyEntries)
                .SelectMany(type => type == "routine" ? new[] { "void", "System.Collections.IEnumerator" } : new[] { type }).ToArray();
            return new UnityMessage(receiver, match.Groups[3].Value, match.Groups[1].Success, returns.Length == 0 ? new[] { "void" } : returns,
                match.Groups[4].Value.Split(", ", StringSplitOptions.RemoveEmptyEntries), match.Groups[5].Success);
        }
    }
}
