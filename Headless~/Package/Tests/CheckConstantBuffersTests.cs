using System.Linq;
using Host.Check;
using NUnit.Framework;
using UnityEngine.Headless;

namespace Host.Tests
{
    /// <summary>Constant buffers that Metal or std140 would read at other bytes than Direct3D.</summary>
    public sealed class CheckConstantBuffersTests
    {
        static Findings Examine(string members, string use = "_A.x")
        {
            string kernel = $"#pragma kernel K\ncbuffer Raw {{ {members} }};\nRWStructuredBuffer<float> _Out;\n[numthreads(1,1,1)] " +
                $"void K() {{ _Out[0] = {use}; }}\n";
            using (var package = new SyntheticPackage().Add("A.compute", kernel))
                return new ConstantBuffersRule().Examine(package.Tree);
        }

        [TestCase("float4 _A; float _B; float4 _C;")]      // a scalar alone: the 4-vector begins at the next 16 bytes everywhere
        [TestCase("row_major float4x4 _F; float4 _A;")]
        public void What_lies_the_same_everywhere_holds(string members) => Assert.That(Examine(members).Faults, Is.Empty);

        [Test]
        public void Four_vectors_matrices_arrays_of_them_and_full_runs_of_scalars_hold()
        {
            Findings findings = Examine("float4 _A; uint _B; float _C; int _D; float _E; float4x4 _F; uint4 _G[3]; float4x4 _H[2]; float4 _I;");
            Assert.That(findings.Faults, Is.Empty);
            Assert.That(findings.Looked, Is.EqualTo("9 members of 1 constant buffers in 1 programs"));
        }

        [TestCase("float3 _A; float _B;", "A.compute (K): Raw._A is a float3, which Metal and std140 pad otherwise")]
        [TestCase("float3 _A; float _B;", "Raw._B is at byte 12 under Direct3D and at 16 under Metal")]
        [TestCase("float4 _A; float _B; float3 _C;", "Raw._C is at byte 20 under Direct3D and at 32 under std140")]
        [TestCase("float4 _A; float2 _B; float2 _C;", "Raw._B is a float2")]
        [TestCase("float4 _A; float _B; float2 _C; float _D;", "Raw._C is at byte 20 under Direct3D and at 24 under std140")]
        [TestCase("float4 _A; uint3 _B; float _C;", "Raw._B is a uint3")]
        [TestCase("float4 _A; float _B[4];", "Raw._B is a float [4]")]
        [TestCase("float4 _A; float3x3 _B;", "Raw._B is a float3x3")]
        [TestCase("float4 _A; float _B;", "Raw ends at byte 20")]
        [TestCase("float4 _A; struct { float3 a; float b; } _B; float4 _C;",
            "Raw._C is at byte 32, where its type and those before it would have it at 16")]
        public void What_other_graphics_APIs_lay_out_otherwise_is_named(string members, string fault)
        {
            Assert.That(Examine(members).Faults, Has.Some.Contains(fault));
        }

        [Test]
        public void Loose_constants_and_buffers_that_Unity_fills_are_left_alone()
        {
            using (var package = new SyntheticPackage().Add("A.compute",
                "#pragma kernel K\ncbuffer UnityPerDraw { float3 _A; float2 _B; };\nfloat3 _C; float _D;\nRWStructuredBuffer<float> " +
                    "_Out;\n[numthreads(1,1,1)] void K() { _Out[0] = _A.x + _B.x + _C.x + _D; }\n"))
                Assert.That(new ConstantBuffersRule().Examine(package.Tree).Faults, Is.Empty);
        }

        [TestCase(0, 12, 16, 28, 32, 96, 208, 220)]
        [TestCase(1, 12, 16, 28, 32, 96, 208, 220)]
        [TestCase(2, 16, 32, 48, 64, 128, 240, 256)]
        public void Offsets_are_those_of_each_specification(int packing, params int[] expected)
        {
            ConstantPacking[] packings = { ConstantPacking.Direct3D, ConstantPacking.Std140, ConstantPacking.Metal };
            var members = new[] { Field(1, 3), Field(1, 1), Field(1, 3), Field(1, 1), Field(4, 4), Field(1, 3, 7), Field(1, 3) };
            Assert.That(packings[packing].Offsets(members).Skip(1), Is.EqualTo(expected));
        }

        static ConstantField Field(int rows, int columns, int length = 0) => new() { Rows = rows, Columns = columns, ArrayLength = length };
    }
}
