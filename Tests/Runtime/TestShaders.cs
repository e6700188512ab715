using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Compute shaders by name.</summary>
    static class TestShaders
    {
        /// <summary>The kernels of a stage, as the package itself loads them.</summary>
        public static ComputeShader Load(string stage) => StageShader.LoadCompute(stage);
    }
}
