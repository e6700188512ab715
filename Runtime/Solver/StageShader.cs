using System;
using UnityEngine;

namespace Rill
{
    /// <summary>
    /// The compute shader or shader of one stage, as an asset under Resources/Rill that is loaded when the stage is first
    /// needed: a component added at run time finds its shaders, and a build can leave out those of unused stages.
    /// </summary>
    public sealed class StageShader : ScriptableObject
    {
        [SerializeField] ComputeShader compute;
        [SerializeField] Shader shader;

        /// <summary>The stage's kernels; null for a stage that only draws.</summary>
        public ComputeShader Compute => compute;

        /// <summary>The stage's passes; null for a stage that only computes.</summary>
        public Shader Shader => shader;

        /// <summary>Loads "Rill/<paramref name="stage"/>" from Resources.</summary>
        /// <exception cref="InvalidOperationException">The asset is missing, as after a build step that stripped it.</exception>
        public static StageShader Load(string stage)
        {
            var asset = Resources.Load<StageShader>("Rill/" + stage);
            if (asset == null)
                throw new InvalidOperationException($"Rill: the asset Resources/Rill/{stage}.asset is not in this build. Reimport the package, or exempt the stage from stripping.");
            return asset;
        }

        /// <summary>The kernels of a stage.</summary>
        /// <exception cref="InvalidOperationException">The asset or its compute shader is missing.</exception>
        public static ComputeShader LoadCompute(string stage)
        {
            ComputeShader compute = Load(stage).compute;
            if (compute == null)
                throw new InvalidOperationException($"Rill: Resources/Rill/{stage}.asset has lost its compute shader. Reimport the package.");
            return compute;
        }
    }
}
