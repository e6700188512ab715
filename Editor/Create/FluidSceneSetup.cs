using System;
using UnityEditor.SceneManagement;
using UnityEngine;

namespace Rill.Editor
{
    /// <summary>Makes a small scene: a basin that a spout feeds and a drain empties, a ball, the ground, and what a scene lacks of camera
    /// and light.</summary>
    static class FluidSceneSetup
    {
        /// <summary>Depth of the water at the start, m.</summary>
        public const float Depth = 0.3f;

        const float Circulation = 0.008f;       // m³/s
        const float SpoutRadius = 0.05f, SpoutSpeed = 1.3f, SpoutHeight = 0.85f;
        const float BallRadius = 0.13f;         // m

        /// <summary>Lets a ball float: adds Rigidbody and Fluid Buoyancy to an object. Null without the physics module.</summary>
        public static Action<GameObject, FluidSimulation> Float;

        /// <summary>The scene below one object, which is selected.</summary>
        /// <param name="parent">Null for the root of the scene, in front of the scene view.</param>
        public static GameObject Create(GameObject parent)
        {
            bool needsCamera = IsMissing<Camera>(), needsLight = IsMissing<Light>();
            var root = new GameObject("Fluid Scene");
            root.SetActive(false);
            SceneSetup.Adopt(root, parent);
            SceneSetup.Unscale(root);
            if (parent == null)
                root.transform.position = SceneSetup.ScenePivot;

            FluidSimulation fluid = SceneSetup.MakeFluid(root, SceneSetup.Fill.Pool).GetComponent<FluidSimulation>();
            fluid.transform.localPosition = new Vector3(0f, SceneSetup.Stand + 0.5f * fluid.DomainSize.y, 0f);
            MakeSpout(fluid);
            fluid.gameObject.SetActive(true);       // with its root
            MakeBall(root, fluid);
            BasinSetup.Box(root, "Ground", new Vector3(-20f, -0.1f, -20f), new Vector3(20f, 0f, 20f), "Paving");
            if (needsCamera)
                MakeCamera(root);
            if (needsLight)
                fluid.GetComponent<FluidSurface>().Sun = MakeLight(root);
            return SceneSetup.FinishInView(root, "Fluid Scene", fluid);
        }

        // In a prefab there is neither camera nor light, and it needs none.
        static bool IsMissing<T>() where T : Component
            => PrefabStageUtility.GetCurrentPrefabStage() == null && SceneSetup.FirstOfScenes<T>(_ => true) == null;

        // Water goes round: what the drain takes out of the far corner comes back through the spout.
        static void MakeSpout(FluidSimulation fluid)
        {
            Vector3 box = fluid.DomainSize;
            float floor = -0.5f * box.y, back = 0.5f * box.z, mouth = back - 0.16f, height = floor + SpoutHeight;
            var center = new Vector3(0.3f * box.x, height, mouth);

            GameObject pillar = BasinSetup.Child(fluid.gameObject, "Pillar");
            BasinSetup.Box(pillar, "Stone", new Vector3(center.x - 0.16f, floor - BasinSetup.Floor, back + 0.08f),
                new Vector3(center.x + 0.16f, height + 0.17f, back + 0.36f), "Stone");
            BasinSetup.Box(pillar, "Cap", new Vector3(center.x - 0.2f, height + 0.17f, back + 0.04f),
                new Vector3(center.x + 0.2f, height + 0.23f, back + 0.4f), "Stone");
            BasinSetup.Pipe(pillar, "Pipe", center, new Vector3(center.x, height, back + 0.1f), 0.068f, "Metal");
            BasinSetup.Pipe(pillar, "Lip", center, center + new Vector3(0f, 0f, 0.03f), 0.08f, "Metal");

            GameObject tap = BasinSetup.Child(fluid.gameObject, "Tap");
            tap.transform.localPosition = center;
            tap.transform.localRotation = Quaternion.Euler(0f, 180f, 0f);
            var emitter = tap.AddComponent<FluidEmitter>();
            emitter.Radius = SpoutRadius;
            emitter.Speed = SpoutSpeed;
            emitter.Rate = 0f;

            GameObject outlet = BasinSetup.Child(fluid.gameObject, "Drain");
            var drain = outlet.AddComponent<FluidDrain>();
            float depth = 4f * fluid.ParticleSpacing;
            drain.Size = new Vector3(0.2f, depth, 0.2f);
            outlet.transform.localPosition = new Vector3(-0.4f * box.x, floor + 0.5f * depth, 0.3f * box.z);
            drain.RateLimit = Circulation;
            drain.RecycleTo = emitter;
        }

        static void MakeBall(GameObject root, FluidSimulation fluid)
        {
            if (Float == null)
                return;
            GameObject ball = BasinSetup.Primitive(root, PrimitiveType.Sphere, "Ball", "Red");
            ball.transform.localPosition = new Vector3(-0.35f, SceneSetup.Stand + Depth + 0.5f * BallRadius, -0.1f);
            ball.transform.localScale = 2f * BallRadius * Vector3.one;
            var collider = ball.AddComponent<FluidCollider>();
            collider.Shape = ColliderShape.Sphere;
            collider.Radius = 0.5f;
            Float(ball, fluid);
        }

        static void MakeCamera(GameObject root)
        {
            GameObject made = BasinSetup.Child(root, "Main Camera");
            made.tag = "MainCamera";
            var camera = made.AddComponent<Camera>();
            camera.fieldOfView = 40f;
            camera.nearClipPlane = 0.1f;
            var eye = new Vector3(-1.5f, 1.65f, -2.6f);
            made.transform.localPosition = eye;
            made.transform.localRotation = Quaternion.LookRotation(new Vector3(0.05f, 0.4f, 0f) - eye);
        }

        // From the side and a little from behind, so that waves glitter and the floor is bright.
        static Light MakeLight(GameObject root)
        {
            GameObject made = BasinSetup.Child(root, "Directional Light");
            var light = made.AddComponent<Light>();
            light.type = LightType.Directional;
            light.color = new Color(1f, 0.957f, 0.84f);
            light.shadows = LightShadows.Soft;
            made.transform.localPosition = 3f * Vector3.up;
            made.transform.localRotation = Quaternion.Euler(52f, 105f, 0f);
            return light;
        }
    }
}
