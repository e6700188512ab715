using System;
using System.Collections.Generic;
using System.Linq;
using Host.Shaders;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>
    /// Data lies in buffers on this host as in Unity: the programs that the host makes, and those made of FXC's bytecode,
    /// want the same resources, constants at the same bytes and elements of the same size. Both stages of a pass fit together
    /// as Direct3D demands.
    /// </summary>
    sealed class LayoutRule : Rule
    {
        readonly string cacheFolder;
        readonly IShaderBackend host, bytecode;

        public LayoutRule() : this(null, ShaderBackend.Glslang, ShaderBackend.Fxc) { }

        public LayoutRule(string cacheFolder, IShaderBackend host, IShaderBackend bytecode)
        {
            this.cacheFolder = cacheFolder;
            this.host = host;
            this.bytecode = bytecode;
        }

        public override string Name => "FXC: layouts equal the host's";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            IReadOnlyList<ShaderVariant> ours = PackageShaders.Variants(package, cacheFolder, findings, out _, host),
                theirs = PackageShaders.Variants(package, cacheFolder, new Findings(), out _, bytecode);
            var compared = ours.Zip(theirs).AsParallel().AsOrdered().Select(pair => Compare(pair.First, pair.Second)).ToList();
            foreach (string fault in compared.SelectMany(c => c.faults))
                findings.Fault(fault);
            findings.Looked = $"{compared.Sum(c => c.buffers)} buffers and {compared.Sum(c => c.constants)} constants of {ours.Count} programs";
            return findings;
        }

        static (int buffers, int constants, List<string> faults) Compare(ShaderVariant ours, ShaderVariant theirs)
        {
            try
            {
                ShaderProgram host = ours.Compile().Program, bytecode = theirs.Compile().Program;
                return (bytecode.Resources.Count(r => r.Stride > 0),
                    bytecode.Resources.Where(r => r.Constants != null).Sum(r => r.Constants.Fields.Length),
                    Differences(host, bytecode).Select(difference => $"{ours}: {difference}").ToList());
            }
            catch (Exception e) when (e is ShaderCompileException or FxcException)
            {
                return (0, 0, new List<string> { $"{ours}: {e.Message}" });
            }
        }

        /// <summary>The host's program may want more than the bytecode's, out of which FXC has optimized what does nothing.</summary>
        public static IEnumerable<string> Differences(ShaderProgram host, ShaderProgram bytecode)
        {
            if ((host.GroupX, host.GroupY, host.GroupZ) != (bytecode.GroupX, bytecode.GroupY, bytecode.GroupZ))
                yield return $"groups are of {host.GroupX} x {host.GroupY} x {host.GroupZ} threads here, FXC's of {bytecode.GroupX} x " +
                    $"{bytecode.GroupY} x {bytecode.GroupZ}";
            foreach (ShaderResource theirs in bytecode.Resources)
            {
                ShaderResource ours = host.Resources.FirstOrDefault(r => r.Name == theirs.Name
                    && (r.Kind == ShaderResourceKind.Counter) == (theirs.Kind == ShaderResourceKind.Counter)
                    && (r.Kind == ShaderResourceKind.Sampler) == (theirs.Kind == ShaderResourceKind.Sampler));
                if (ours == null)
                    yield return $"FXC's program reads '{theirs.Name}', a {theirs.Kind}, which the host's does not";
                else if (ours.Kind != theirs.Kind)
                    yield return $"'{theirs.Name}' is a {ours.Kind} here, FXC's a {theirs.Kind}";
                else if (ours.Stride != theirs.Stride)
                    yield return $"an element of '{theirs.Name}' has {ours.Stride} bytes here, FXC's {theirs.Stride}";
                else if (theirs.Constants != null)
                    foreach (string difference in Differences(theirs.Name, ours.Constants, theirs.Constants))
                        yield return difference;
            }
        }

        static IEnumerable<string> Differences(string buffer, ConstantLayout host, ConstantLayout bytecode)
        {
            if (host.Bytes != bytecode.Bytes)
                yield return $"{buffer} has {host.Bytes} bytes here, FXC's {bytecode.Bytes}";
            foreach (string name in host.Fields.Select(f => f.Name).Union(bytecode.Fields.Select(f => f.Name)))
            {
                List<string> ours = Lines(host, name), theirs = Lines(bytecode, name);
                if (!ours.SequenceEqual(theirs))
                    yield return $"{buffer}.{name} is {(ours.Count > 0 ? ours[0] : "missing")} here, FXC's is " +
                        $"{(theirs.Count > 0 ? theirs[0] : "missing")}";
            }
        }

        // A bool is a word like a uint.
        static List<string> Lines(ConstantLayout layout, string name) => layout.Fields.Where(f => f.Name == name).Select(f =>
            $"{(f.Type == ConstantType.Bool ? ConstantType.UInt : f.Type)} {f.Rows} x " +
            $"{f.Columns}{(f.ArrayLength > 0 ? $" [{f.ArrayLength}] every {f.ArrayStride} bytes" : "")}"
            + $"{(f.MatrixStride > 0 ? (f.RowMajor ? " by rows" : " by columns") : "")} of {f.Bytes} bytes at byte {f.Offset}").ToList();
    }
}
