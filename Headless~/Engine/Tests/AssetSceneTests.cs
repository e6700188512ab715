using System.Linq;
using Fixtures;
using Host.Assets;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Host.Tests
{
    public class AssetSceneTests : AssetFixture
    {
        ProjectAssets project;
        Scene scene;
        Everything everything;

        [SetUp]
        public void Load()
        {
            project = Open();
            scene = LoadMain(project);
            everything = Get<Everything>(scene, "Everything");
        }

        [Test]
        public void Roots_come_in_the_order_that_the_scene_lists() =>
            Assert.That(scene.GetRootGameObjects().Select(r => r.name),
            Is.EqualTo(new[] { "Sun", "Rig of the scene", "Main Camera", "Everything", "Early", "Off", "Right twin" }));

        [Test]
        public void Transforms_have_their_place_in_the_hierarchy()
        {
            var child = Get<Part>(scene, "Everything/Asleep").transform;
            Assert.That(child.parent, Is.SameAs(everything.transform));
            Assert.That(everything.transform.localPosition, Is.EqualTo(new Vector3(1, 2, 3)));
            Assert.That(everything.transform.localScale, Is.EqualTo(new Vector3(2, 2, 2)));
            Assert.That(Quaternion.Angle(everything.transform.localRotation, Quaternion.Euler(0, 90, 0)), Is.LessThan(1e-3f));
            Assert.That(child.localPosition, Is.EqualTo(Vector3.zero));
        }

        [Test]
        public void Objects_have_tag_layer_and_activity()
        {
            var camera = scene.GetRootGameObjects().Single(r => r.name == "Main Camera");
            Assert.That(camera.tag, Is.EqualTo("MainCamera"));
            Assert.That(camera.layer, Is.EqualTo(5));
            Assert.That(Get<Part>(scene, "Everything/Asleep").gameObject.activeSelf, Is.False);
            Assert.That(Get<Part>(scene, "Off").enabled, Is.False);
        }

        [Test]
        public void Numbers_of_every_width_arrive()
        {
            Assert.That(everything.flag, Is.True);
            Assert.That(everything.small, Is.EqualTo(200));
            Assert.That(everything.signedSmall, Is.EqualTo(-100));
            Assert.That(everything.twoBytes, Is.EqualTo(-30000));
            Assert.That(everything.unsignedTwoBytes, Is.EqualTo(60000));
            Assert.That(everything.number, Is.EqualTo(-2000000000));
            Assert.That(everything.unsignedNumber, Is.EqualTo(4000000000));
            Assert.That(everything.large, Is.EqualTo(-9000000000000000000));
            Assert.That(everything.unsignedLarge, Is.EqualTo(18000000000000000000));
            Assert.That(everything.real, Is.EqualTo(1.5e-05f));
            Assert.That(everything.precise, Is.EqualTo(0.1234567890123456));
            Assert.That(everything.letter, Is.EqualTo('W'));
        }

        [Test]
        public void Text_and_enums_arrive()
        {
            Assert.That(everything.text, Is.EqualTo("It's 50% water: #1"));
            Assert.That(everything.lines, Is.EqualTo("first line\nsecond line, which is so long that the editor breaks it in the file"));
            Assert.That(everything.flow, Is.EqualTo(Flow.Drip));
            Assert.That(everything.packedFlows, Is.EqualTo(new[] { Flow.Drip, Flow.Jet }));
        }

        [Test]
        public void Vectors_and_colors_arrive()
        {
            Assert.That(everything.v2.x, Is.EqualTo(1));
            Assert.That(everything.v2.y, Is.EqualTo(float.NegativeInfinity));
            Assert.That(everything.v3.y, Is.NaN);
            Assert.That(everything.v4, Is.EqualTo(new Vector4(1, 2, 3, 4)));
            Assert.That(everything.v2i, Is.EqualTo(new Vector2Int(-1, 2)));
            Assert.That(everything.v3i, Is.EqualTo(new Vector3Int(-1, 2, -3)));
            Assert.That(everything.turn.y, Is.EqualTo(0.7071068f));
            Assert.That(everything.color, Is.EqualTo(new Color(0.1f, 0.2f, 0.3f, 0.4f)));
            // 2149580803 = 0x80200003
            Assert.That(everything.color32, Is.EqualTo(new Color32(0x03, 0x00, 0x20, 0x80)));
            Assert.That(everything.rect, Is.EqualTo(new Rect(1, 2, 3, 4)));
            Assert.That(everything.bounds.size, Is.EqualTo(new Vector3(1, 2, 3)));
            Assert.That(everything.mask.value, Is.EqualTo(-1));
            Assert.That(everything.matrix[1, 2], Is.EqualTo(6));
            Assert.That(everything.hash.ToString(), Is.EqualTo("000102030405060708090a0b0c0d0e0f"));
        }

        [Test]
        public void Unity_Mathematics_values_arrive()
        {
            Assert.That(everything.mathematicsVector.Equals(new float3(1, 2, 3)));
            Assert.That(everything.mathematicsInts.Equals(new int2(-7, 8)));
            Assert.That(everything.mathematicsTurn.value.Equals(new float4(0, 1, 0, 0)));
        }

        [Test]
        public void Curves_keep_keys_tangents_and_ends()
        {
            // Slopes 2 at the inner ends and a rise of 2: the straight line v = 2 t.
            Assert.That(everything.curve.keys.Select(k => (k.time, k.value, k.inTangent, k.outTangent)),
                Is.EqualTo(new[] { (0f, 0f, 0f, 2f), (1f, 2f, 2f, 0f) }));
            Assert.That(everything.curve.Evaluate(0.25f), Is.EqualTo(0.5f).Within(1e-6f));
            Assert.That(everything.curve.preWrapMode, Is.EqualTo(WrapMode.Loop));
            Assert.That(everything.curve.postWrapMode, Is.EqualTo(WrapMode.ClampForever));
        }

        [Test]
        public void Gradients_keep_their_keys()
        {
            Assert.That(everything.gradient.mode, Is.EqualTo(GradientMode.Fixed));
            Assert.That(everything.gradient.colorKeys.Select(k => k.time), Is.EqualTo(new[] { 0f, 16384 / 65535f, 1f }).Within(1e-4f));
            Assert.That(everything.gradient.colorKeys[1].color.g, Is.EqualTo(1));
            Assert.That(everything.gradient.alphaKeys.Select(k => k.alpha), Is.EqualTo(new[] { 1f, 0.5f }));
        }

        [Test]
        public void Groups_keep_what_the_file_lacks()
        {
            Assert.That(everything.nozzle.radius, Is.EqualTo(0.5f));
            Assert.That(everything.nozzle.Label, Is.EqualTo("spray"));
            Assert.That(everything.ramp.steps, Is.EqualTo(9));
            Assert.That(everything.ramp.slope, Is.EqualTo(0.25f), "as the constructor left it");
            Assert.That(everything.kept, Is.EqualTo(42));
        }

        [Test]
        public void Lists_and_arrays_arrive()
        {
            Assert.That(everything.nozzles.Select(n => (n.radius, n.Label)), Is.EqualTo(new[] { (1f, "a"), (2f, "b") }));
            Assert.That(everything.ramps.Select(r => (r.steps, r.slope)), Is.EqualTo(new[] { (1, 2f), (5, 3f) }));
            Assert.That(everything.packed, Is.EqualTo(new[] { 1, -2 }));
            Assert.That(everything.bytes, Is.EqualTo(new byte[] { 0, 255, 127 }));
            Assert.That(everything.flags, Is.EqualTo(new[] { true, false, true }));
            Assert.That(everything.reals, Is.EqualTo(new[] { 1f, -2.5f, 1e20f }));
            Assert.That(everything.names, Is.EqualTo(new[] { "plain", "", "quoted: yes" }));
            Assert.That(everything.points, Is.EqualTo(new[] { new Vector3(1, 2, 3), new Vector3(4, 5, 6) }), "instead of the constructor's list");
        }

        [Test]
        public void References_find_objects_of_the_scene()
        {
            Assert.That(everything.target, Is.SameAs(everything.other.transform));
            Assert.That(everything.other.name, Is.EqualTo("Main Camera"));
            Assert.That(everything.self, Is.SameAs(everything), "a negative file id");
        }

        [Test]
        public void References_find_assets_by_guid()
        {
            Assert.That(everything.compute.name, Is.EqualTo("Sum"));
            Assert.That(everything.recipe.sum, Is.SameAs(everything.compute), "one object for everybody");
            Assert.That(everything.recipes, Is.EqualTo(new[] { everything.recipe, null }));
        }

        [Test]
        public void Managed_references_keep_type_and_identity()
        {
            Assert.That(everything.shape, Is.TypeOf<Ball>());
            Assert.That(((Ball)everything.shape).bounce, Is.EqualTo(0.5f));
            Assert.That(everything.shape.size, Is.EqualTo(3));
            Assert.That(everything.shapes.Count, Is.EqualTo(3));
            Assert.That(((Box)everything.shapes[0]).edges, Is.EqualTo(new Vector3(1, 2, 3)));
            Assert.That(everything.shapes[1], Is.SameAs(everything.shape));
            Assert.That(everything.shapes[2], Is.Null);
        }

        [Test]
        public void Renamed_fields_are_found_by_their_former_names()
        {
            Assert.That(everything.renamed, Is.EqualTo(12.5f));
            Assert.That(everything.RenamedTwice, Is.EqualTo(4));
            Assert.That(everything.Inherited, Is.EqualTo(6.25f), "of a base class, and private");
        }

        [Test]
        public void Fields_that_Unity_does_not_store_stay_untouched()
        {
            Assert.That(everything.transient, Is.EqualTo(8));
            Assert.That(everything.Secret, Is.EqualTo(9));
            Assert.That(everything.table, Is.Null);
            Assert.That(everything.buffer, Is.Null);
            Assert.That(everything.routine, Is.Null);
            Assert.That(everything.block, Is.Null);
        }

        [Test]
        public void Properties_with_a_serialized_field_behind_them_arrive() => Assert.That(everything.Viscosity, Is.EqualTo(1e-6f));

        [Test]
        public void What_is_lacking_is_empty_but_never_null()
        {
            Assert.That(everything.neverNull, Is.EqualTo(""));
            Assert.That(everything.neverNullList, Is.Empty);
            Assert.That(everything.neverNullRamp.steps, Is.EqualTo(5));
            Assert.That(everything.neverNullRamp.inner, Is.Not.Null);
        }

        [Test]
        public void A_key_without_a_field_is_a_warning() =>
            Assert.That(project.Warnings, Has.Some.Contains("Everything on 'Everything'").And.Contains(
            "no serialized field 'goneField'").And.StartsWith("Assets/Scenes/Main.unity("));

        [Test]
        public void Callbacks_come_once_after_all_values()
        {
            Assert.That(everything.afterDeserialize, Is.EqualTo(1));
            Assert.That(everything.realSeenByCallback, Is.EqualTo(everything.real));
        }

        [Test]
        public void Cameras_and_lights_have_their_settings()
        {
            var camera = Get<Camera>(scene, "Main Camera");
            Assert.That((camera.nearClipPlane, camera.farClipPlane, camera.fieldOfView, camera.depth), Is.EqualTo((0.3f, 500f, 45f, -1f)));
            Assert.That(camera.clearFlags, Is.EqualTo(CameraClearFlags.SolidColor));
            Assert.That(camera.backgroundColor, Is.EqualTo(new Color(0.25f, 0.5f, 0.75f, 0)));
            Assert.That(camera.cullingMask, Is.EqualTo(-1));
            var light = Get<Light>(scene, "Sun");
            Assert.That((light.type, light.intensity, light.enabled, light.shadows),
                Is.EqualTo((LightType.Directional, 1.25f, false, LightShadows.Soft)));
            Assert.That(light.color, Is.EqualTo(new Color(1, 0.9f, 0.8f, 1)));
        }

        [Test]
        public void The_scene_sets_its_ambient_light()
        {
            Assert.That(RenderSettings.ambientSkyColor, Is.EqualTo(new Color(0.2f, 0.3f, 0.4f, 1)));
            Assert.That(RenderSettings.ambientMode, Is.EqualTo(UnityEngine.Rendering.AmbientMode.Flat));
        }

        [Test]
        public void Two_scripts_of_one_name_are_told_apart_by_their_namespace() =>
            Assert.That(Get<Fixtures.Right.Twin>(scene, "Right twin").side, Is.EqualTo(2));

        [Test]
        public void Scripts_wake_in_the_order_of_their_meta_files()
        {
            Assert.That(Part.Log.Take(2), Is.EqualTo(new[] { "Awake Early", "OnEnable Early" }));
            Assert.That(Part.Log, Has.No.Member("Awake Asleep"));
            Assert.That(Part.Log, Has.Member("Awake Off").And.No.Member("OnEnable Off"));
        }

        // ---- prefabs

        [Test]
        public void Prefab_instances_have_their_overrides()
        {
            var nozzle = Get<Part>(scene, "Everything/Nozzle of the scene");
            Assert.That(nozzle.size, Is.EqualTo(2), "the prefab's own");
            Assert.That(nozzle.counts, Is.Empty, "shortened");
            Assert.That(nozzle.nozzles.Select(n => (n.radius, n.offset.y, n.Label)), Is.EqualTo(new[] { (0.5f, 0f, "inner"), (0.5f, 8f, "outer") }));
            Assert.That(nozzle.transform.localPosition, Is.EqualTo(new Vector3(1, 2, 3)));
            Assert.That(nozzle.partner, Is.SameAs(Get<Part>(scene, "Everything/Asleep")), "to an object of the scene");
        }

        [Test]
        public void Components_and_children_are_removed_and_added()
        {
            var tip = Get<Transform>(scene, "Everything/Nozzle of the scene/Tip");
            Assert.That(tip.GetComponents<Part>().Select(p => p.size), Is.EqualTo(new[] { 33f }), "3 was removed, 33 added");
            Assert.That(Get<Transform>(scene, "Everything/Nozzle of the scene/Added child").localPosition.z, Is.EqualTo(9));
        }

        [Test]
        public void What_is_inside_of_a_prefab_instance_is_neither_destroyed_nor_moved_in_edit_mode()
        {
            UnityEngine.Headless.EditMode.IsOn = true;
            GameObject rig = Get<Part>(scene, "Rig of the scene").gameObject, tip = Get<Part>(scene, "Rig of the scene/Left Nozzle/Tip").gameObject;
            GameObject added = Get<Transform>(scene, "Everything/Nozzle of the scene/Added child").gameObject;
            const string refusal = "Destroying a GameObject inside a Prefab instance is not allowed.";
            Assert.That(PrefabUtility.IsPartOfPrefabInstance(rig) && PrefabUtility.IsPartOfPrefabInstance(tip.GetComponent<Part>()));
            Assert.That(PrefabUtility.IsPartOfPrefabInstance(added) || PrefabUtility.IsAddedGameObjectOverride(tip), Is.False);
            Assert.That(PrefabUtility.IsAddedGameObjectOverride(added));
            Assert.That(() => Object.DestroyImmediate(tip), Throws.InvalidOperationException.With.Message.EqualTo(refusal));
            Assert.That(() => Undo.DestroyObjectImmediate(tip.transform.parent.gameObject), Throws.InvalidOperationException);
            LogAssert.Expect(LogType.Error, "Setting the parent of a transform which resides in a Prefab instance is not possible " +
                "(GameObject: 'Tip').");
            tip.transform.SetParent(null);
            Assert.That(tip.transform.parent != null);
            Object.DestroyImmediate(tip.GetComponent<Part>());
            Assert.That(tip.GetComponent<Part>() == null, "a component is an override");
            Object.DestroyImmediate(added);
            Assert.That(added == null, "what was added goes");
            Object.DestroyImmediate(rig);
            Assert.That(tip == null, "with the whole instance");
        }

        [Test]
        public void What_is_inside_of_a_prefab_instance_goes_in_play_mode()
        {
            GameObject tip = Get<Part>(scene, "Rig of the scene/Left Nozzle/Tip").gameObject;
            Assert.That(PrefabUtility.IsPartOfPrefabInstance(tip), Is.False);
            Object.DestroyImmediate(tip);
            Assert.That(tip == null);
        }

        [Test]
        public void Prefabs_in_prefabs_are_overridden_at_both_levels()
        {
            var left = Get<Part>(scene, "Rig of the scene/Left Nozzle");
            var leftTip = Get<Part>(scene, "Rig of the scene/Left Nozzle/Tip");
            var right = Get<Part>(scene, "Rig of the scene/Right Nozzle");
            Assert.That(left.size, Is.EqualTo(7), "by the outer prefab");
            Assert.That(left.transform.localPosition, Is.EqualTo(new Vector3(-4, 2, 3)));
            Assert.That(left.counts, Is.EqualTo(new[] { 1, 2, 3 }));
            Assert.That(leftTip.size, Is.EqualTo(70), "by the scene");
            Assert.That(right.size, Is.EqualTo(2));
            Assert.That(right.gameObject.activeSelf, Is.False);
            Assert.That(Get<Part>(scene, "Rig of the scene/Right Nozzle/Tip").size, Is.EqualTo(71), "by the scene, through a made-up id");
            Assert.That(Get<Transform>(scene, "Rig of the scene").localPosition.y, Is.EqualTo(11));
        }

        [Test]
        public void References_within_a_prefab_stay_within_its_instance()
        {
            var left = Get<Part>(scene, "Rig of the scene/Left Nozzle");
            var leftTip = Get<Part>(scene, "Rig of the scene/Left Nozzle/Tip");
            Assert.That(left.partner, Is.SameAs(leftTip));
            Assert.That(leftTip.partner, Is.SameAs(left));
            Assert.That(Get<Part>(scene, "Rig of the scene").partner, Is.SameAs(leftTip), "across the nested instance");
            Assert.That(Get<Part>(scene, "Rig of the scene/Right Nozzle").partner, Is.SameAs(Get<Part>(scene, "Rig of the scene/Right Nozzle/Tip")));
        }

        [Test]
        public void An_override_without_a_target_is_a_warning()
            => Assert.That(project.Warnings, Has.Some.Contains("object 999999, which the prefab no longer has"));

        [Test]
        public void A_prefab_asset_can_be_instantiated_and_does_not_wake_itself()
        {
            Part.Log.Clear();
            var prefab = project.LoadAtPath<GameObject>("Assets/Prefabs/Rig.prefab");
            Assert.That(Part.Log, Is.Empty);
            Assert.That(prefab.scene.IsValid(), Is.False);
            var copy = Object.Instantiate(prefab);
            Assert.That(Part.Log, Is.EqualTo(new[] { "Awake Rig(Clone)", "OnEnable Rig(Clone)", "Awake Left Nozzle", "OnEnable Left Nozzle",
                "Awake Tip", "OnEnable Tip" }));
            Assert.That(copy.GetComponent<Part>().partner, Is.SameAs(copy.transform.Find("Left Nozzle/Tip").GetComponent<Part>()));
            Assert.That(prefab.GetComponent<Part>().partner, Is.SameAs(prefab.transform.Find("Left Nozzle/Tip").GetComponent<Part>()));
        }

        [Test]
        public void A_variant_overrides_its_base()
        {
            var body = TemporaryProject.Header
                + "--- !u!1001 &70\nPrefabInstance:\n  m_Modification:\n    m_TransformParent: {fileID: 0}\n    m_Modifications:\n"
                + "    - target: {fileID: 12, guid: e0000000000000000000000000000004, type: 3}\n      propertyPath: size\n      value: " +
                "6\n      objectReference: {fileID: 0}\n"
                + "  m_SourcePrefab: {fileID: 100100000, guid: e0000000000000000000000000000004, type: 3}\n";
            var variants = Temporary().Write("Assets/Base.prefab", TemporaryProject.SceneText("  size: 5\n"),
                "e0000000000000000000000000000004").Write("Assets/Variant.prefab", body, "e0000000000000000000000000000005").Open();
            Assert.That(variants.LoadAtPath<Part>("Assets/Base.prefab").size, Is.EqualTo(5));
            Assert.That(variants.LoadAtPath<Part>("Assets/Variant.prefab").size, Is.EqualTo(6));
            // The made-up id of the base's component in the variant.
            Assert.That(((Part)variants.LoadAsset("e0000000000000000000000000000005", 70 ^ 12, typeof(Part))).size, Is.EqualTo(6));
        }

        [Test]
        public void Prefabs_of_editors_before_2018_3_are_read()
        {
            const string guid = "e0000000000000000000000000000004";
            var prefab = TemporaryProject.SceneText("  size: 5\n") + "--- !u!1001 &100100000\nPrefab:\n  m_Modification:\n    " +
                "m_Modifications: []\n  m_ParentPrefab: {fileID: 0}\n  m_RootGameObject: {fileID: 10}\n  m_IsPrefabParent: 1\n";
            var old = TemporaryProject.Header + $"--- !u!1001 &70\nPrefab:\n  m_Modification:\n    m_TransformParent: {{fileID: 0}}\n  " +
                $"  m_Modifications:\n    - target: {{fileID: 12, guid: {guid}, type: 2}}\n"
                + $"      propertyPath: size\n      value: 8\n      objectReference: {{fileID: 0}}\n    m_RemovedComponents: []\n  " +
                $"m_ParentPrefab: {{fileID: 100100000, guid: {guid}, type: 2}}\n  m_IsPrefabParent: 0\n"
                + $"--- !u!4 &71 stripped\nTransform:\n  m_PrefabParentObject: {{fileID: 11, guid: {guid}, type: 2}}\n  " +
                $"m_PrefabInternal: {{fileID: 70}}\n"
                + "--- !u!1 &80\nGameObject:\n  m_Component:\n  - 4: {fileID: 81}\n  m_Name: Child\n  m_IsActive: 1\n--- !u!4 " +
                "&81\nTransform:\n  m_GameObject: {fileID: 80}\n  m_Father: {fileID: 71}\n";
            var loaded = Temporary().Write("Assets/Old.prefab", prefab, guid).Write("Assets/Main.unity", old, null).Load();
            Assert.That(Get<Part>(loaded, "Tank").size, Is.EqualTo(8));
            Assert.That(Get<Transform>(loaded, "Tank/Child").childCount, Is.Zero);
        }

        [TestCase("Main")]
        [TestCase("Scenes/Main")]
        [TestCase("Assets/Scenes/Main.unity")]
        public void Scenes_load_by_name_and_path(string name)
        {
            var again = SceneManager.LoadNow(name, LoadSceneMode.Single);
            Assert.That(again.IsValid());
            Assert.That(again.buildIndex, Is.EqualTo(0), "the first of the build settings");
            Assert.That(everything == null, "the old scene's objects are destroyed");
        }
    }
}
