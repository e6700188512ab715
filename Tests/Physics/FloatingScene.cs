using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Rill.Tests
{
    /// <summary>A tank of water with one free body; what the body did, frame by frame.</summary>
    sealed class FloatingScene : IDisposable
    {
        public const float Spacing = 0.05f, Frame = 1f / 60f, Density = 1000f, Gravity = 9.81f;

        public readonly FluidSimulation Fluid;
        public readonly FluidCollider Obstacle;
        public readonly Rigidbody Body;
        public readonly FluidBuoyancy Buoyancy;
        public readonly float Volume, Depth, Side;

        /// <summary>Height of the body's center over the floor, m, and its velocity, m/s, after each frame.</summary>
        public readonly List<float> Heights = new List<float>(), Speeds = new List<float>();
        /// <summary>Largest change of the body's velocity over the time in which it came, m/s²; of its angular velocity, rad/s².</summary>
        public float PeakAcceleration { get; private set; }

        readonly List<GameObject> made = new List<GameObject>();
        readonly float least;
        Vector3 lastVelocity;
        float sampledAt = -1f;

        /// <param name="size">Sides of a box, m; of a ball its diameter.</param>
        /// <param name="layers">Of water.</param>
        /// <param name="liquid">Material of the liquid in the tank; null for the fluid's own.</param>
        /// <param name="byLayer">A collider of Unity's physics that the fluid takes by layer, instead of a Fluid Collider with a Fluid
        /// Buoyancy.</param>
        public FloatingScene(ColliderShape shape, Vector3 size, float densityRatio, float height, int layers = 12, int side = 26,
            DeepWater deepWater = DeepWater.On, bool byLayer = false, FluidMaterialAsset liquid = null)
        {
            Side = side * Spacing;
            var tank = new Vector3(Side, 40 * Spacing, Side);
            GameObject fluid = Make("Fluid");
            fluid.transform.position = new Vector3(0f, tank.y / 2f, 0f);
            Fluid = fluid.AddComponent<FluidSimulation>();
            Fluid.Configure(tank, Spacing, side * side * layers);
            SolverSettings settings = SolverSettings.Default;
            settings.deepWater = deepWater;
            Fluid.Settings = settings;
            Fluid.StatisticsInterval = 30;
            GameObject water = Make("Water");
            water.transform.SetParent(fluid.transform, false);
            water.transform.localPosition = new Vector3(0f, (layers * Spacing - tank.y) / 2f, 0f);
            FluidVolume volume = water.AddComponent<FluidVolume>();
            volume.Size = new Vector3(Side, layers * Spacing, Side);
            volume.Material = liquid;

            GameObject body = Make("Body");
            body.transform.position = new Vector3(0f, height, 0f);
            if (byLayer)
            {
                AddUnityCollider(body, shape, size);
            }
            else
            {
                Obstacle = body.AddComponent<FluidCollider>();
                Obstacle.Shape = shape;
                Obstacle.Size = size;
                Obstacle.Radius = size.x / 2f;
            }
            bool isBall = shape == ColliderShape.Sphere;
            Volume = isBall ? Mathf.PI / 6f * size.x * size.x * size.x : size.x * size.y * size.z;
            Body = body.AddComponent<Rigidbody>();
            Body.mass = densityRatio * Density * Volume;
            BoxInertia.Set(Body, size);
            if (isBall)
                Body.inertiaTensor = Vector3.one * (0.1f * Body.mass * size.x * size.x);
            Body.interpolation = RigidbodyInterpolation.Interpolate;
            if (!byLayer)
                Buoyancy = body.AddComponent<FluidBuoyancy>();
            least = size.y / 2f;
            Depth = layers * Spacing;
            for (int i = made.Count - 1; i >= 0; i--)       // the fluid after its water
                made[i].SetActive(true);
        }

        void AddUnityCollider(GameObject body, ColliderShape shape, Vector3 size)
        {
            const int Layer = 8;
            body.layer = Layer;
            if (shape == ColliderShape.Sphere)
                body.AddComponent<SphereCollider>().radius = size.x / 2f;
            else
                body.AddComponent<BoxCollider>().size = size;
            var colliders = Fluid.gameObject.AddComponent<FluidPhysicsColliders>();
            colliders.ColliderLayers = colliders.FloatingLayers = 1 << Layer;
        }

        /// <summary>Level of the water over the floor, m, from the number and the mean height of its particles: under plain iterations it
        /// stands lower than it was filled in, the deeper the more, and a body that begins under water displaces some.</summary>
        public float Level => Fluid.TryGetStatistics(out FluidStatistics statistics)
            ? statistics.particles * (Spacing * Spacing * Spacing) / (Side * Side) * statistics.volumeRatio : Depth;

        /// <summary>Plays on; a body that came to the floor stops there.</summary>
        /// <param name="eachFrame">Called before each; null for nothing.</param>
        public IEnumerator Play(float seconds, Action eachFrame = null)
        {
            for (int i = 0; i < Mathf.RoundToInt(seconds / Frame); i++)
            {
                eachFrame?.Invoke();
                yield return null;
                if (Time.fixedTime == sampledAt)
                    continue;       // a frame without a step of the physics: what was added has not acted yet
                float time = sampledAt < 0f ? Time.fixedDeltaTime : Time.fixedTime - sampledAt;
                sampledAt = Time.fixedTime;
                Vector3 velocity = Body.GetPointVelocity(Body.worldCenterOfMass);
                Heights.Add(Body.position.y);
                Speeds.Add(velocity.magnitude);
                PeakAcceleration = Mathf.Max(PeakAcceleration, (velocity - lastVelocity).magnitude / time);
                lastVelocity = velocity;
                if (Body.position.y >= least || Body.isKinematic)
                    continue;
                Body.position = new Vector3(Body.position.x, least, Body.position.z);
                Body.AddForce(-velocity, ForceMode.VelocityChange);
                lastVelocity = Vector3.zero;
            }
        }

        public void Dispose()
        {
            foreach (GameObject gameObject in made)
                Object.Destroy(gameObject);
        }

        GameObject Make(string name)
        {
            var gameObject = new GameObject(name);
            gameObject.SetActive(false);
            made.Add(gameObject);
            return gameObject;
        }
    }
}
