using UnityEngine;

namespace Rill.Samples
{
    /// <summary>A renderer of one's own: draws the particles of a phase as glints, straight from the GPU.</summary>
    [DefaultExecutionOrder(FluidSimulation.ExecutionOrder + 100)]       // after the fluid has stepped
    public sealed class ParticleGlints : MonoBehaviour
    {
        [Tooltip("Whose particles are drawn.")]
        [SerializeField] FluidSimulation fluid;

        [Tooltip("With the shader ParticleGlints.shader.")]
        [SerializeField] Material material;

        MaterialPropertyBlock properties;

        void LateUpdate()
        {
            if (fluid == null || material == null || !fluid.TryGetParticles(out FluidParticles particles))
                return;
            properties ??= new MaterialPropertyBlock();
            particles.Bind(properties);
            var parameters = new RenderParams(material)
            {
                matProps = properties,
                worldBounds = new Bounds(fluid.transform.position, fluid.DomainSize.magnitude * Vector3.one),
                layer = gameObject.layer,
            };
            Graphics.RenderPrimitivesIndirect(parameters, MeshTopology.Triangles, particles.DrawArguments, 1, 0);
        }
    }
}
