using UnityEngine;

namespace Rill.Tests
{
    /// <summary>Compute shaders by name: the package's stages, and those of the tests alone.</summary>
    static class TestShaders
    {
        /// <summary>The kernels of a stage, as the package itself loads them.</summary>
        public static ComputeShader Load(string stage) => StageShader.LoadCompute(stage);

        /// <summary>A compute shader under Tests/Runtime/Resources/RillTests.</summary>
        public static ComputeShader LoadProbe(string name)
        {
            var shader = Resources.Load<ComputeShader>("RillTests/" + name);
            if (shader == null)
                throw new System.InvalidOperationException($"Tests/Runtime/Resources/RillTests/{name}.compute was not imported.");
            return shader;
        }
    }
}
