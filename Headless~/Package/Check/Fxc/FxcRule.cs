using System;
using System.Collections.Generic;
using System.Linq;
using Host.Shaders;
using UnityEngine.Headless;

namespace Host.Check
{
    /// <summary>Microsoft's compiler takes every variant of every program as Unity gives it, and has nothing to say about it.</summary>
    sealed class FxcRule : Rule
    {
        static readonly FxcAllowance[] Allowances = { };

        readonly string cacheFolder;
        readonly IReadOnlyList<string> toolFolders;
        readonly IReadOnlyList<FxcAllowance> allowances;

        public FxcRule() : this(null, null, Allowances) { }

        public FxcRule(string cacheFolder, IReadOnlyList<string> toolFolders, IReadOnlyList<FxcAllowance> allowances)
        {
            this.cacheFolder = cacheFolder;
            this.toolFolders = toolFolders;
            this.allowances = allowances;
        }

        public override string Name => "FXC: every kernel and stage compiles without warnings";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            IReadOnlyList<ShaderVariant> all = PackageShaders.Variants(package, cacheFolder, findings, out int files);
            List<ShaderVariant> variants = Compilable(all, findings);
            foreach (string include in PackageShaders.Unread(package, all))
                findings.Fault($"{include}: no kernel or stage of the package includes it, so nothing shows that it compiles; write a " +
                    $"test's kernel that does, or delete it");
            IReadOnlyList<FxcResult> results;
            try
            {
                results = new FxcCompiler(cacheFolder, toolFolders).CompileAll(variants.ConvertAll(v => v.Fxc));
            }
            catch (FxcException e)
            {
                findings.Fault(e.Message);
                return findings;
            }

            Judge(variants, results, findings);
            Measure(variants, results, findings);
            findings.Looked = $"{variants.Count(v => v.Stage == ShaderStage.Compute)} kernels and " +
                $"{variants.Count(v => v.Stage != ShaderStage.Compute)} stages, each variant counted, of {files} files";
            return findings;
        }

        // Variants that do not reach FXC are faults already.
        static List<ShaderVariant> Compilable(IReadOnlyList<ShaderVariant> variants, Findings findings)
        {
            var compilable = new List<ShaderVariant>();
            foreach (ShaderVariant variant in variants)
                if (variant.Fault != null)
                    findings.Fault($"{variant.Fault.Message}; in {variant}");
                else if (FxcDialect.NeedsDxc(variant.Fxc.Source, out PragmaLine asking))
                    findings.Fault($"{variant}: #pragma {asking.Text} asks for DXC, which is not run here, so nothing shows that this " +
                        $"compiles in Unity");
                else if (PackageShaders.StandIns(variant).FirstOrDefault() is string standIn)
                    findings.Fault($"{variant}: includes {standIn}, of which only a stand-in is here, so nothing shows that this compiles in Unity");
                else
                    compilable.Add(variant);
            foreach (IGrouping<string, PragmaLine> line in variants.Where(v => v.Fxc != null).SelectMany(v => v.Fxc.Source.Pragmas)
                .Where(Keywords.AreOfUnity).GroupBy(p => $"{p.Where.File}({p.Where.Line})"))
                findings.Fault($"{line.Key}: the variants of #pragma {line.First().Text} are not compiled here: their keywords are " +
                    $"Unity's own; write them out with multi_compile");
            return compilable;
        }

        void Judge(List<ShaderVariant> variants, IReadOnlyList<FxcResult> results, Findings findings)
        {
            // One line of an include is reported once for every variant that has it.
            var said = variants.Zip(results).SelectMany(pair => pair.Second.Messages, (pair, message) => (message, variant: pair.First))
                .GroupBy(s => s.message.ToString());
            var used = new HashSet<FxcAllowance>();
            foreach (var message in said)
            {
                FxcMessage first = message.First().message;
                FxcAllowance allowance = first.IsError ? null
                    : allowances.FirstOrDefault(a => a.Number == first.Number && a.File == first.Where.File);
                if (allowance != null)
                    used.Add(allowance);
                else
                    findings.Fault($"{message.Key}; in {Few(message.Select(s => s.variant))}");
            }
            foreach (FxcAllowance allowance in allowances.Where(a => !used.Contains(a)))
                findings.Fault($"FXC does not say {allowance.Number} of {allowance.File} any more, which was allowed since " +
                    $"{allowance.Reason}: strike it from the list of allowances");
        }

        static string Few(IEnumerable<ShaderVariant> variants)
        {
            const int most = 3;
            List<ShaderVariant> all = variants.ToList();
            return string.Join(", ", all.Take(most)) + (all.Count > most ? $" and {all.Count - most} more" : "");
        }

        static void Measure(List<ShaderVariant> variants, IReadOnlyList<FxcResult> results, Findings findings)
        {
            var table = new ResultTable
            {
                Title = "Cost of each kernel",
                About = "As Microsoft's compiler for Direct3D 11 counts it (d3dcompiler_47.dll, shader model 5.0, optimization level " +
                    "3): instruction slots and registers of four words. Buffers are those read only, UAVs those written.",
                Columns = KernelBudget.Columns,
            };
            foreach ((ShaderVariant variant, FxcResult result) in variants.Zip(results).Where(pair => pair.Second.Success))
                try
                {
                    var budget = new KernelBudget(variant, result.Dxbc);
                    table.Rows.Add(budget.Row());
                    foreach (string fault in budget.Faults())
                        findings.Fault(fault);
                }
                catch (FormatException e)
                {
                    findings.Fault($"{variant}: {e.Message}");
                }
            findings.Tables.Add(table);
        }
    }
}
