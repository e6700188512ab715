using System.Runtime.InteropServices;
using UnityEngine;
using UnityEngine.Rendering;

public class SPHManager : MonoBehaviour
{
    [StructLayout(LayoutKind.Sequential, Size = 44)]
    public struct Particle
    {
        public Vector3 position;
        public Vector3 velocity;
        public Vector3 force;
        public float density;
        public float pressure;
    }

    [Header("Particles")]
    public Vector3Int particlesPerAxis = new Vector3Int(10, 10, 10);
    public float spacing = 0.1f;
    [Range(0f, 0.05f)] public float jitter = 0.01f;

    [Header("Simulation")]
    public Vector3 boxSize = new Vector3(4, 4, 1);
    public float smoothingRadius = 0.2f;
    public float restDensity = 1000f;
    public float soundSpeed = 20f;
    public float viscosity = 0.1f;
    public Vector3 gravity = new Vector3(0, -9.81f, 0);
    public float boundDamping = -0.3f;
    public float timeStep = 0.002f;
    public int substeps = 4;
    public ComputeShader shader;

    [Header("Rendering")]
    public Mesh particleMesh;
    public Material material;
    public float renderSize = 0.1f;

    // Order of the #pragma kernel lines in SPH.compute
    const int kernelDensityPressure = 0;
    const int kernelForces = 1;
    const int kernelIntegrate = 2;
    const int THREADS = 100;

    private Particle[] particles;
    private ComputeBuffer particleBuffer;
    private ComputeBuffer argsBuffer;
    private int count;
    private bool paused = false;

    private static readonly int SizeProperty = Shader.PropertyToID("_size");
    private static readonly int ParticlesBufferProperty = Shader.PropertyToID("_particlesBuffer");

    void Awake()
    {
        SpawnParticles();
        SetupBuffers();
    }

    void SpawnParticles()
    {
        Random.InitState(42);
        count = particlesPerAxis.x * particlesPerAxis.y * particlesPerAxis.z;
        particles = new Particle[count];
        int i = 0;
        for (int x = 0; x < particlesPerAxis.x; x++)
        for (int y = 0; y < particlesPerAxis.y; y++)
        for (int z = 0; z < particlesPerAxis.z; z++)
        {
            Vector3 pos = new Vector3(x + 0.5f, y + 0.5f, z + 0.5f) * spacing;
            pos += Random.insideUnitSphere * jitter;
            particles[i++] = new Particle { position = pos, density = restDensity };
        }
    }

    void SetupBuffers()
    {
        uint[] args =
        {
            particleMesh.GetIndexCount(0),
            (uint)count,
            particleMesh.GetIndexStart(0),
            particleMesh.GetBaseVertex(0),
            0
        };
        argsBuffer = new ComputeBuffer(1, args.Length * sizeof(uint), ComputeBufferType.IndirectArguments);
        argsBuffer.SetData(args);

        particleBuffer = new ComputeBuffer(count, 11 * sizeof(float));
        particleBuffer.SetData(particles);

        shader.SetBuffer(kernelDensityPressure, "_particles", particleBuffer);
        shader.SetBuffer(kernelForces, "_particles", particleBuffer);
        shader.SetBuffer(kernelIntegrate, "_particles", particleBuffer);

        material.SetFloat(SizeProperty, renderSize);
        material.SetBuffer(ParticlesBufferProperty, particleBuffer);
    }

    void Update()
    {
        if (Input.GetKeyDown(KeyCode.Space))
            paused = !paused;

        if (!paused)
        {
            shader.SetInt("particleLength", count);
            shader.SetFloat("particleMass", restDensity * spacing * spacing * spacing);
            shader.SetFloat("viscosity", viscosity);
            shader.SetFloat("restDensity", restDensity);
            shader.SetFloat("stiffness", restDensity * soundSpeed * soundSpeed / 7f);
            shader.SetFloat("boundDamping", boundDamping);
            shader.SetFloat("radius", smoothingRadius);
            shader.SetFloat("timestep", timeStep);
            shader.SetVector("gravity", gravity);
            shader.SetFloats("boxSize", boxSize.x, boxSize.y, boxSize.z);

            int groups = Mathf.CeilToInt(count / (float)THREADS);
            for (int s = 0; s < substeps; s++)
            {
                shader.Dispatch(kernelDensityPressure, groups, 1, 1);
                shader.Dispatch(kernelForces, groups, 1, 1);
                shader.Dispatch(kernelIntegrate, groups, 1, 1);
            }
        }

        Graphics.DrawMeshInstancedIndirect(
            particleMesh,
            0,
            material,
            new Bounds(Vector3.zero, boxSize * 10f),
            argsBuffer,
            castShadows: ShadowCastingMode.Off);
    }

    void OnDestroy()
    {
        particleBuffer?.Dispose();
        argsBuffer?.Dispose();
    }

    private void OnDrawGizmos()
    {
        Gizmos.color = Color.cyan;
        Gizmos.DrawWireCube(transform.position + boxSize / 2, boxSize);
    }
}
