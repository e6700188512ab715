using System;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;

namespace Rill.Tests
{
    /// <summary>Parameters of a shader that one call sets: each gets its own value, by the type that the value has.</summary>
    public class ShaderParametersTests
    {
        readonly MaterialPropertyBlock block = new MaterialPropertyBlock();

        [Test]
        public void Each_value_is_set_under_its_name_by_its_type()
        {
            var parameters = new ShaderParameters("_Bool", "_Int", "_Uint", "_Float", "_Float3", "_Float4", "_Texture");
            parameters.Set(block, true, -3, 0x80000001u, 0.5f, new float3(1f, 2f, 3f), new float4(4f, 5f, 6f, 7f), Texture2D.whiteTexture);
            Assert.That((block.GetInteger("_Bool"), block.GetInteger("_Int"), (uint)block.GetInteger("_Uint"), block.GetFloat("_Float")),
                Is.EqualTo((1, -3, 0x80000001u, 0.5f)));
            Assert.That((block.GetVector("_Float3"), block.GetVector("_Float4")),
                Is.EqualTo((new Vector4(1f, 2f, 3f, 0f), new Vector4(4f, 5f, 6f, 7f))));
            Assert.That(block.GetTexture("_Texture"), Is.SameAs(Texture2D.whiteTexture));
        }

        [Test]
        public void What_is_null_stays_as_it_is()
        {
            block.SetTexture("_Texture", Texture2D.whiteTexture);
            new ShaderParameters("_Texture", "_Int").Set(block, (Texture)null, 7);
            Assert.That(block.GetTexture("_Texture"), Is.SameAs(Texture2D.whiteTexture));
            Assert.That(block.GetInteger("_Int"), Is.EqualTo(7));
        }

        [Test]
        public void Numbers_and_buffers_reach_a_kernel()
        {
            ComputeShader shader = StageShader.LoadCompute("Clear");
            int kernel = shader.FindKernel("ClearWords");
            using (GraphicsBuffer buffer = GpuBuffer.Structured<uint>("Rill.Words", 5))
            using (var cmd = new CommandBuffer())
            {
                buffer.SetData(new uint[] { 1, 2, 3, 4, 5 });
                new ShaderParameters("_Count", "_Words").Bind(cmd, shader, kernel, 3, buffer);
                cmd.DispatchCompute(shader, kernel, 1, 1, 1);
                Graphics.ExecuteCommandBuffer(cmd);
                var words = new uint[5];
                buffer.GetData(words);
                Assert.That(words, Is.EqualTo(new uint[] { 0, 0, 0, 4, 5 }));
            }
        }

        [Test]
        public void A_name_without_a_value_or_a_value_without_a_name_is_refused()
        {
            var parameters = new ShaderParameters("_Int", "_Float");
            Assert.Throws<ArgumentException>(() => parameters.Set(block, 1));
            Assert.Throws<ArgumentException>(() => parameters.Set(block, 1, 2f, 3));
        }
    }
}
