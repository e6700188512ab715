using System.Collections.Generic;
using System.Runtime.InteropServices;
using UnityEngine;
using UnityEngine.Rendering;

namespace Flocking
{
    public class FlockManager : Singleton<FlockManager>
    {
        const int GROUP_SIZE = 128;

        [StructLayout(LayoutKind.Sequential)]
        struct Boid
        {
            public Vector3 position;
            public Vector3 velocity;
            public float noise;

            public static int Size => sizeof(float) * 7;
        }

        [Header("Resources")]
        public ComputeShader flockShader;
        public Mesh boidMesh;
        public Material boidMaterial;

        [Header("Flock")]
        public int boidCount = 1000;
        public int seed = 42;
        public float spawnRadius = 10f;
        [Range(0.1f, 5f)] public float neighborDistance = 2f;
        public float speed = 4f;
        [Tooltip("How strongly boids steer, in 1/s")]
        public float rotationSpeed = 3f;
        public float viewRadius = 14f;
        public Transform target;

        ComputeBuffer boidBuffer;
        ComputeBuffer visibleBuffer;
        ComputeBuffer argsBuffer;
        uint[] args = new uint[5] { 0, 0, 0, 0, 0 };

        int simulateKernel, cullKernel;
        Bounds bounds;
        int groups;

        public int Count { get { return boidCount; } }
        public bool Paused { get; set; }

        void Start()
        {
            simulateKernel = flockShader.FindKernel("Simulate");
            cullKernel = flockShader.FindKernel("Cull");

            uint x;
            flockShader.GetKernelThreadGroupSizes(simulateKernel, out x, out _, out _);
            Debug.Assert(x == GROUP_SIZE, "group size has changed");
            groups = Mathf.CeilToInt(boidCount / (float)x);

            bounds = new Bounds(Vector3.zero, Vector3.one * 1000);

            InitBoids();
            InitArgs();
        }

        void InitBoids()
        {
            Random.InitState(seed);
            var boids = new List<Boid>(boidCount);
            for (int i = 0; i < boidCount; i++)
            {
                Boid boid = new Boid();
                boid.position = transform.position + Random.insideUnitSphere * spawnRadius;
                boid.velocity = Random.onUnitSphere * speed;
                boid.noise = Random.value * 0.5f + 0.75f;
                boids.Add(boid);
            }
            boidBuffer = new ComputeBuffer(boidCount, Boid.Size);
            boidBuffer.SetData(boids);
            visibleBuffer = new ComputeBuffer(boidCount, Boid.Size, ComputeBufferType.Append);
        }

        void InitArgs()
        {
            args[0] = boidMesh.GetIndexCount(0);
            args[1] = 0;
            args[2] = boidMesh.GetIndexStart(0);
            args[3] = boidMesh.GetBaseVertex(0);
            argsBuffer = new ComputeBuffer(1, args.Length * sizeof(uint), ComputeBufferType.IndirectArguments);
            argsBuffer.SetData(args);
        }

        void Update()
        {
            if (Input.GetKeyDown(KeyCode.P))
                Paused = !Paused;
            if (Input.GetKey(KeyCode.Escape))
                Application.Quit();

            if (!Paused)
                Simulate();
            Draw();
        }

        void Simulate()
        {
            Vector3 goal = target != null ? target.position : transform.position;
            flockShader.SetInt("boidCount", boidCount);
            flockShader.SetFloat("deltaTime", Time.deltaTime);
            flockShader.SetFloat("speed", speed);
            flockShader.SetFloat("rotationSpeed", rotationSpeed);
            flockShader.SetFloat("neighborDistance", neighborDistance);
            flockShader.SetVector("goal", goal);
            flockShader.SetBuffer(simulateKernel, "boidBuffer", boidBuffer);
            flockShader.Dispatch(simulateKernel, groups, 1, 1);
        }

        void Draw()
        {
            visibleBuffer.SetCounterValue(0);
            flockShader.SetFloat("viewRadius", viewRadius);
            flockShader.SetVector("viewCenter", transform.position);
            flockShader.SetBuffer(cullKernel, "boidBuffer", boidBuffer);
            flockShader.SetBuffer(cullKernel, "visibleBuffer", visibleBuffer);
            flockShader.Dispatch(cullKernel, groups, 1, 1);
            ComputeBuffer.CopyCount(visibleBuffer, argsBuffer, sizeof(uint));

            boidMaterial.SetBuffer("boidBuffer", visibleBuffer);
            Graphics.DrawMeshInstancedIndirect(boidMesh, 0, boidMaterial, bounds, argsBuffer, 0, null, ShadowCastingMode.Off, false);
        }

        void OnDestroy()
        {
            boidBuffer?.Release();
            visibleBuffer?.Release();
            argsBuffer?.Release();
        }

        void OnDrawGizmosSelected()
        {
            Gizmos.color = Color.yellow;
            Gizmos.DrawWireSphere(transform.position, spawnRadius);
        }
    }
}
