using System.Collections.Generic;
using Host.Shaders;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>Resources of a Direct3D 11.0 device that a program takes, from its bytecode.</summary>
    sealed class KernelBudget
    {
        // Direct3D 11.0, cs_5_0 (D3D11_PS_CS_UAV_REGISTER_COUNT, D3D11_CS_TGSM_REGISTER_COUNT words, D3D11_CS_THREAD_GROUP_MAX_THREADS_PER_GROUP).
        const int MaxUavs = 8, MaxGroupsharedBytes = 32768, MaxThreads = 1024;

        public static readonly string[] Columns = { "file", "kernel or stage", "keywords", "group", "instructions", "registers",
            "groupshared B", "UAVs", "buffers", "textures" };

        readonly ShaderVariant variant;
        readonly DxbcStatistics statistics;
        readonly DxbcDeclarations declarations;

        public KernelBudget(ShaderVariant variant, byte[] dxbc)
        {
            this.variant = variant;
            var container = new DxbcContainer(dxbc);
            statistics = new DxbcStatistics(container);
            declarations = new DxbcDeclarations(container);
        }

        int Threads => declarations.GroupSize.x * declarations.GroupSize.y * declarations.GroupSize.z;

        /// <summary>FXC checks some of it itself, and reports it as errors.</summary>
        public IEnumerable<string> Faults()
        {
            if (declarations.Uavs > MaxUavs)
                yield return $"{variant}: {declarations.Uavs} UAVs, but Direct3D 11.0 has {MaxUavs}; pack buffers together or split the kernel";
            if (declarations.GroupsharedBytes > MaxGroupsharedBytes)
                yield return $"{variant}: {declarations.GroupsharedBytes} bytes of groupshared memory, but Direct3D 11 has " +
                    $"{MaxGroupsharedBytes}; use smaller groups or types";
            if (Threads > MaxThreads)
                yield return $"{variant}: groups of {Threads} threads, but Direct3D 11 has {MaxThreads}";
        }

        public string[] Row() => new[]
        {
            variant.File, variant.Program, variant.Keywords.Length > 0 ? variant.Keywords : "-",
            variant.Stage == ShaderStage.Compute ? $"{declarations.GroupSize.x} x {declarations.GroupSize.y} x {declarations.GroupSize.z}" : "-",
            statistics.Instructions.ToString(), statistics.TempRegisters.ToString(), declarations.GroupsharedBytes.ToString(),
            declarations.Uavs.ToString(), declarations.Buffers.ToString(), declarations.Textures.ToString(),
        };
    }
}
