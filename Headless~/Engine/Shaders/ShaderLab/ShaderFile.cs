using System;
using System.Collections.Concurrent;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>A .shader file. Programs compile when first asked for; any thread may ask.</summary>
    sealed class ShaderFile : ShaderSource
    {
        static readonly Dictionary<string, int> Queues = new Dictionary<string, int>(StringComparer.OrdinalIgnoreCase)
        {
            ["Background"] = 1000, ["Geometry"] = 2000, ["AlphaTest"] = 2450, ["GeometryLast"] = 2500, ["Transparent"] = 3000, ["Overlay"] = 4000,
        };

        readonly ParsedShader parsed;
        readonly PassFile[] passes;
        readonly Func<ParsedPass, ParsedSubShader, bool, PassFile> read;

        /// <param name="pipeline">The RenderPipeline tag of the pipeline that runs; empty for the Built-in one.</param>
        public ShaderFile(string filePath, string displayPath, IncludeResolver resolver, ShaderCompiler compiler, string pipeline = "")
        {
            Path = displayPath;
            parsed = ShaderLabParser.Parse(SourceText.Read(filePath), displayPath, (package, versions) => HasPackage(resolver, package, versions));
            // A SubShader of a scriptable render pipeline is passed over where that pipeline does not run.
            ParsedSubShader usable = parsed.SubShaders.FirstOrDefault(s => s.Available && s.Passes.Any(p => p.Available)
                && (!s.Tags.TryGetValue("RenderPipeline", out string wanted) || wanted.Length == 0 || wanted == pipeline));
            read = (pass, subShader, caster) => new PassFile(pass, subShader, parsed.Name, System.IO.Path.GetFullPath(filePath),
                displayPath, compiler, caster);
            passes = usable == null ? Array.Empty<PassFile>() : usable.Passes.Where(p => p.Available).SelectMany(p => PassesOf(p, usable)).ToArray();
            RenderQueue = usable != null && usable.Tags.TryGetValue("Queue", out string queue) ? ParseQueue(queue) : Queues["Geometry"];
            if (usable == null)
                parsed.Notes.Add("no SubShader is for the pipeline and packages of this project");
        }

        // The version of the pipeline with a stand-in is known; that of other packages is not needed.
        static bool HasPackage(IncludeResolver resolver, string package, string versions)
            => resolver?.Invoke($"Packages/{package}/package.json") != null
            && (package != Player.PipelinePackage || VersionRange.Contains(versions, Player.PipelineVersion));

        public override string Path { get; }
        public override string Name => parsed.Name;
        public override IReadOnlyList<ShaderProperty> Properties => parsed.Properties;
        public override IReadOnlyList<string> Keywords => passes.SelectMany(p => p.Keywords).Distinct().ToArray();
        public override IReadOnlyList<ShaderPassSource> Passes => passes;
        public override int RenderQueue { get; }
        public override string Fallback => parsed.Fallback;
        public override IReadOnlyList<string> Notes => parsed.Notes;

        /// <summary>
        /// Every vertex and fragment program of every pass under every choice of keywords that makes a difference to it; of
        /// every SubShader, those of other pipelines and absent packages too, since Unity compiles them where those are.
        /// </summary>
        /// <exception cref="ShaderCompileException">A pragma is wrong, or the keywords make too many.</exception>
        public IReadOnlyList<ShaderVariant> AllVariants()
            => parsed.SubShaders.SelectMany(subShader => subShader.Passes.SelectMany(pass => PassesOf(pass, subShader)))
            .SelectMany(pass => pass.AllVariants()).ToList();

        // A surface shader with addshadow has a second pass.
        IEnumerable<PassFile> PassesOf(ParsedPass pass, ParsedSubShader subShader)
        {
            PassFile own = read(pass, subShader, false);
            return own.AddsShadow ? new[] { own, read(pass, subShader, true) } : new[] { own };
        }

        // "Transparent", "Geometry+10", "Overlay - 1".
        int ParseQueue(string text)
        {
            string compact = text.Replace(" ", "");
            int sign = compact.IndexOfAny(new[] { '+', '-' });
            string name = sign < 0 ? compact : compact.Substring(0, sign);
            int offset = 0;
            if (!Queues.TryGetValue(name, out int queue) || sign >= 0
                && !int.TryParse(compact.Substring(sign), NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out offset))
                throw new ShaderCompileException(Path, 1, $"'{text}' is not a render queue");
            return queue + offset;
        }
    }

    sealed class PassFile : ShaderPassSource
    {
        const int DefaultTarget = 25;

        readonly ShaderCompiler compiler;
        readonly ParsedPass pass;
        readonly string shaderName, displayPath;
        readonly List<SourceSegment> segments;
        readonly Keywords keywords;
        readonly RenderState state;
        readonly SurfaceOptions surface;
        readonly bool caster;
        readonly string proceduralFunction;
        readonly int target = DefaultTarget;
        readonly Dictionary<ShaderStage, (string name, SourceLine where)> entries = new Dictionary<ShaderStage, (string, SourceLine)>();
        readonly ConcurrentDictionary<string, Lazy<CompiledProgram>> programs = new ConcurrentDictionary<string, Lazy<CompiledProgram>>();

        /// <param name="caster">The pass of a surface shader that draws its shadow, rather than the one that draws it lit.</param>
        public PassFile(ParsedPass pass, ParsedSubShader subShader, string shaderName, string diskPath, string displayPath,
            ShaderCompiler compiler, bool caster = false)
        {
            this.pass = pass;
            this.caster = caster;
            this.compiler = compiler;
            this.shaderName = shaderName;
            this.displayPath = displayPath;
            Name = caster ? "ShadowCaster" : pass.Name;
            Tags = new Dictionary<string, string>(subShader.Tags);
            foreach (KeyValuePair<string, string> tag in pass.Tags)
                Tags[tag.Key] = tag.Value;
            if (caster)
                Tags["LightMode"] = "ShadowCaster";

            segments = pass.Code.Select(c => new SourceSegment { Text = c.Text, FirstLine = c.FirstLine, DiskPath = diskPath,
                DisplayPath = displayPath }).ToList();
            if (pass.Code[pass.Code.Count - 1].Cg)
                segments.InsertRange(0, ImplicitIncludes(diskPath));
            if (pass.Surface)
                segments.Insert(pass.Code[pass.Code.Count - 1].Cg ? 2 : 0,
                    new SourceSegment { Text = SurfaceShader.Prologue(caster), DiskPath = diskPath, DisplayPath = "(surface shader)" });
            List<PragmaLine> pragmas = compiler.ReadPragmas(segments, ShaderStage.Vertex, DefaultTarget);
            foreach (PragmaLine pragma in pragmas)
            {
                string[] words = pragma.Text.Split(new[] { ' ', '\t' }, StringSplitOptions.RemoveEmptyEntries);
                string argument = words.Length > 1 ? words[1] : "";
                switch (words[0])
                {
                    case "vertex": entries[ShaderStage.Vertex] = (argument, pragma.Where); break;
                    case "fragment": entries[ShaderStage.Fragment] = (argument, pragma.Where); break;
                    case "instancing_options":
                        string procedural = words.Skip(1).FirstOrDefault(w => w.StartsWith("procedural:", StringComparison.Ordinal));
                        if (procedural != null)
                            proceduralFunction = procedural.Substring("procedural:".Length);
                        break;
                    case "surface":
                        if (!pass.Surface)
                            throw new ShaderCompileException(pragma.Where.File, pragma.Where.Line,
                                "a surface shader must not stand inside of a Pass");
                        surface = new SurfaceOptions(pragma);
                        entries[ShaderStage.Vertex] = (SurfaceShader.VertexEntry, pragma.Where);
                        entries[ShaderStage.Fragment] = (SurfaceShader.FragmentEntry, pragma.Where);
                        break;
                    case "geometry":
                    case "hull":
                    case "domain":
                        throw new ShaderCompileException(pragma.Where.File, pragma.Where.Line,
                            $"#pragma {words[0]} is not supported by this host; vertex and fragment programs are");
                    case "target":
                        if (float.TryParse(argument, NumberStyles.Float, CultureInfo.InvariantCulture, out float version))
                            target = (int)Math.Round(version * 10);
                        break;
                }
            }
            if (pass.Surface && surface == null)
                throw new ShaderCompileException(displayPath, pass.Line, "a program outside of a Pass needs #pragma surface");
            if (surface != null && !surface.NoInstancing
                && !pragmas.Any(p => p.Text.StartsWith("multi_compile_instancing", StringComparison.Ordinal)))
                pragmas.Add(new PragmaLine("multi_compile_instancing", entries[ShaderStage.Vertex].where));
            if (surface != null && surface.ReceivesShadows && !caster)
                pragmas.Add(new PragmaLine("multi_compile _ SHADOWS_SCREEN", entries[ShaderStage.Vertex].where));
            keywords = new Keywords(pragmas, proceduralFunction != null, stereo: true);
            state = surface == null ? pass.State : caster ? pass.State.ForCaster() : pass.State.With(surface.Blend);
        }

        public IReadOnlyList<string> Keywords => keywords.All;

        /// <summary>Whether it is a surface shader that asks for a pass to cast its shadow.</summary>
        public bool AddsShadow => surface != null && surface.AddShadow;

        // Unity puts these before every CGPROGRAM.
        static IEnumerable<SourceSegment> ImplicitIncludes(string diskPath)
            => new[] { "HLSLSupport.cginc", "UnityShaderVariables.cginc" }.Select(f => new SourceSegment { Text = $"#include \"{f}\"",
                DiskPath = diskPath, DisplayPath = f });

        public override DeviceRasterState ResolveState(Func<string, float> property) => state.Resolve(property);

        public override ShaderProgram Compile(ShaderStage stage, ICollection<string> enabledKeywords)
            => CompileLinked(stage, enabledKeywords).Program;

        public IReadOnlyList<ShaderVariant> AllVariants()
        {
            var variants = new List<ShaderVariant>();
            foreach (ShaderStage stage in new[] { ShaderStage.Vertex, ShaderStage.Fragment })
            {
                var list = new VariantList(compiler, displayPath, $"{(Name.Length > 0 ? Name + "/" : "")}{Entry(stage).name}");
                foreach (string[] enabled in keywords.Choices(displayPath))
                    list.Add(Request(stage, enabled), enabled, () => CompileLinked(stage, enabled));
                variants.AddRange(list.Variants);
            }
            return variants;
        }

        (string name, SourceLine where) Entry(ShaderStage stage) => entries.TryGetValue(stage, out (string, SourceLine) entry) ? entry
            : throw new ShaderCompileException(displayPath, pass.Line,
            $"this pass has no #pragma {(stage == ShaderStage.Vertex ? "vertex" : "fragment")}");

        CompiledProgram CompileLinked(ShaderStage stage, ICollection<string> enabledKeywords)
        {
            // The fragment program's inputs are numbered as the vertex program's outputs, which have a variant of their own.
            Varying[] outputs = stage == ShaderStage.Fragment ? CompileLinked(ShaderStage.Vertex, enabledKeywords).Outputs : Array.Empty<Varying>();
            string key = stage + " " + string.Join(" ", Defines(stage, enabledKeywords).Select(d => d.Key + "=" + d.Value)) + " "
                + string.Join(" ", outputs.Select(o => o.Semantic));
            return programs.GetOrAdd(key, _ => new Lazy<CompiledProgram>(() =>
            {
                CompileRequest request = Request(stage, enabledKeywords);
                request.VertexOutputs = outputs;
                return compiler.Compile(request);
            })).Value;
        }

        List<KeyValuePair<string, string>> Defines(ShaderStage stage, ICollection<string> enabledKeywords)
        {
            List<KeyValuePair<string, string>> defines = ShaderCompiler.PlatformDefines(stage, target)
                .Concat(keywords.Select(stage, enabledKeywords)).ToList();
            // Direct3D 11 has no multiview: that variant is for Vulkan, which Unity compiles by FXC too.
            if (enabledKeywords != null && enabledKeywords.Contains(Shaders.Keywords.StereoMultiview))
                defines[defines.FindIndex(d => d.Key == "SHADER_API_D3D11")] = KeyValuePair.Create("SHADER_API_VULKAN", "1");
            if (proceduralFunction != null)
                defines.Add(KeyValuePair.Create("UNITY_INSTANCING_PROCEDURAL_FUNC", proceduralFunction));
            if (surface != null && surface.Blend == SurfaceBlend.Premultiplied)
                defines.Add(KeyValuePair.Create("_ALPHAPREMULTIPLY_ON", "1"));
            return defines;
        }

        CompileRequest Request(ShaderStage stage, ICollection<string> enabledKeywords)
        {
            (string name, SourceLine where) entry = Entry(stage);
            List<KeyValuePair<string, string>> defines = Defines(stage, enabledKeywords);
            return new CompileRequest
            {
                Name = $"{displayPath} ({shaderName}{(Name.Length > 0 ? "/" + Name : "")}, {entry.name})",
                Stage = stage,
                Target = target,
                EntryPoint = entry.name,
                EntryLine = entry.where,
                Segments = surface == null ? segments : segments.Append(Generated(defines, entry.where)).ToList(),
                Defines = defines,
            };
        }

        // Its text depends on the variant: the Input may have members under #if.
        SourceSegment Generated(List<KeyValuePair<string, string>> defines, SourceLine pragma)
        {
            string own = compiler.Preprocess(segments, defines);
            try
            {
                return new SourceSegment { Text = SurfaceShader.Generate(surface, own, caster),
                    DiskPath = segments[segments.Count - 1].DiskPath, DisplayPath = displayPath + " (code around the surface function)" };
            }
            catch (ProgramException e)
            {
                throw new ShaderCompileException(pragma.File, pragma.Line, e.Message);
            }
        }
    }
}
