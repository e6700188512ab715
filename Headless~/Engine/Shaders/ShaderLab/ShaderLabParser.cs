using System;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace Host.Shaders
{
    sealed class ParsedPass
    {
        public string Name = "";
        public int Line;
        public Dictionary<string, string> Tags = new Dictionary<string, string>();
        public RenderState State;
        /// <summary>The program stands in the SubShader itself: its pass is written by the host.</summary>
        public bool Surface;
        /// <summary>Whether the project has the packages that it requires.</summary>
        public bool Available = true;
        /// <summary>Include blocks before the pass, then its own program.</summary>
        public List<CodeBlock> Code = new List<CodeBlock>();
    }

    sealed class ParsedSubShader
    {
        public Dictionary<string, string> Tags = new Dictionary<string, string>();
        public List<ParsedPass> Passes = new List<ParsedPass>();
        /// <summary>Whether the project has the packages that it requires.</summary>
        public bool Available = true;
    }

    sealed class ParsedShader
    {
        public string Name;
        public List<ShaderProperty> Properties = new List<ShaderProperty>();
        public List<ParsedSubShader> SubShaders = new List<ParsedSubShader>();
        /// <summary>The shader named by Fallback; empty for none and for Off.</summary>
        public string Fallback = "";
        /// <summary>Requests of the file that the host leaves out.</summary>
        public List<string> Notes = new List<string>();
    }

    /// <summary>ShaderLab by recursive descent, as the manual's "ShaderLab" reference lists it.</summary>
    sealed class ShaderLabParser
    {
        readonly ShaderLabReader reader;
        readonly Func<string, string, bool> hasPackage;
        readonly ParsedShader shader = new ParsedShader();

        ShaderLabParser(string text, string path, Func<string, string, bool> hasPackage)
        {
            reader = new ShaderLabReader(text, path);
            this.hasPackage = hasPackage;
        }

        /// <param name="hasPackage">Whether the project has a package of that name in that range of versions; SubShaders and passes that
        /// require others are marked.</param>
        /// <exception cref="ShaderCompileException"/>
        public static ParsedShader Parse(string text, string path, Func<string, string, bool> hasPackage)
        {
            var parser = new ShaderLabParser(text, path, hasPackage);
            parser.ReadShader();
            return parser.shader;
        }

        /// <summary>Inherited state of a Category, SubShader or Pass.</summary>
        sealed class Scope
        {
            public RenderState State = new RenderState();
            public Dictionary<string, string> Tags = new Dictionary<string, string>();
            public List<CodeBlock> Includes = new List<CodeBlock>();
            public bool Available = true;

            public Scope Inner() => new Scope
            {
                State = State.Copy(),
                Tags = new Dictionary<string, string>(Tags),
                Includes = new List<CodeBlock>(Includes),
            };
        }

        void ReadShader()
        {
            if (!reader.TryReadWord("Shader"))
                throw reader.Unexpected("Shader");
            shader.Name = reader.ReadText();
            reader.Expect('{');
            ReadShaderBody(new Scope());
            if (reader.Kind != LabTokenKind.End)
                throw reader.Unexpected("the end of the file");
        }

        void ReadShaderBody(Scope scope)
        {
            while (!reader.TryReadSymbol('}'))
            {
                if (reader.TryReadWord("Properties"))
                    ReadProperties();
                else if (reader.TryReadWord("SubShader"))
                    ReadSubShader(scope.Inner());
                else if (reader.TryReadWord("Category"))
                {
                    reader.Expect('{');
                    ReadShaderBody(scope.Inner());
                }
                else if (reader.TryReadWord("Fallback"))
                {
                    shader.Fallback = reader.TryReadWord("Off") ? "" : reader.ReadText();
                }
                else if (reader.TryReadWord("CustomEditor"))
                    reader.ReadText();
                else if (reader.TryReadWord("CustomEditorForRenderPipeline"))
                {
                    reader.ReadText();
                    reader.ReadText();
                }
                else if (reader.TryReadWord("Dependency"))
                {
                    reader.ReadText();
                    reader.Expect('=');
                    reader.ReadText();
                }
                else if (!TryReadCommon(scope))
                    throw reader.Unexpected("Properties, SubShader or '}'");
            }
        }

        // Reads what may stand in a shader, a SubShader and a pass alike.
        bool TryReadCommon(Scope scope)
        {
            if (reader.TryTakeCode("INCLUDE", out CodeBlock include))
                scope.Includes.Add(include);
            else if (reader.TryReadWord("Tags"))
                ReadPairs('=', scope.Tags);
            else if (reader.TryReadWord("LOD"))
                reader.ReadNumber();
            else
                return scope.State.TryRead(reader, shader.Notes);
            return true;
        }

        void ReadPairs(char between, Dictionary<string, string> pairs)
        {
            reader.Expect('{');
            while (!reader.TryReadSymbol('}'))
            {
                string key = reader.ReadText();
                string value = "";
                if (reader.TryReadSymbol(between))
                    value = reader.ReadText();
                else if (between == '=')
                    throw reader.Unexpected("'='");
                pairs[key] = value;
            }
        }

        bool TryReadRequirements(Scope scope)
        {
            if (!reader.TryReadWord("PackageRequirements"))
                return false;
            var packages = new Dictionary<string, string>();
            ReadPairs(':', packages);
            foreach ((string package, string versions) in packages)
                scope.Available &= package == "unity" || hasPackage(package, versions);
            return true;
        }

        void ReadSubShader(Scope scope)
        {
            var subShader = new ParsedSubShader();
            int notes = shader.Notes.Count;
            reader.Expect('{');
            while (!reader.TryReadSymbol('}'))
            {
                if (reader.TryReadWord("Pass"))
                    ReadPass(subShader, scope);
                else if (reader.TryReadWord("UsePass"))
                    shader.Notes.Add($"line {reader.Line}: UsePass \"{reader.ReadText()}\" is left out");
                else if (reader.TryReadWord("GrabPass"))
                {
                    shader.Notes.Add($"line {reader.Line}: GrabPass is left out");
                    reader.SkipBraces();
                }
                else if (reader.TryTakeCode("PROGRAM", out CodeBlock surface))
                    ReadSurface(subShader, scope, surface);
                else if (!TryReadRequirements(scope) && !TryReadCommon(scope))
                    throw reader.Unexpected("Pass, Tags, render state or '}'");
            }
            subShader.Tags = scope.Tags;
            subShader.Available = scope.Available;
            shader.SubShaders.Add(subShader);
            if (!scope.Available)
                shader.Notes.RemoveRange(notes, shader.Notes.Count - notes);
        }

        void ReadSurface(ParsedSubShader subShader, Scope scope, CodeBlock program)
        {
            var pass = new ParsedPass { Name = "FORWARD", Line = program.FirstLine, State = scope.State.Copy(), Surface = true };
            pass.Tags["LightMode"] = "ForwardBase";
            pass.Code.AddRange(scope.Includes.FindAll(i => i.Cg == program.Cg));
            pass.Code.Add(program);
            subShader.Passes.Add(pass);
        }

        void ReadPass(ParsedSubShader subShader, Scope outer)
        {
            var pass = new ParsedPass { Line = reader.Line };
            Scope scope = outer.Inner();
            scope.Tags.Clear();     // the SubShader's tags may still follow; they are joined later
            CodeBlock program = null;
            reader.Expect('{');
            while (!reader.TryReadSymbol('}'))
            {
                if (reader.TryReadWord("Name"))
                    pass.Name = reader.ReadText();
                else if (reader.TryTakeCode("PROGRAM", out CodeBlock code))
                    program = code;
                else if (reader.IsWord("SetTexture") || reader.IsWord("Material") || reader.IsWord("GLSLPROGRAM"))
                    throw reader.Error($"{reader.Value} is of the fixed-function pipeline or of OpenGL; a pass needs an HLSLPROGRAM");
                else if (!TryReadRequirements(scope) && !TryReadCommon(scope))
                    throw reader.Unexpected("Name, Tags, render state, HLSLPROGRAM or '}'");
            }
            if (program == null)
                throw new ShaderCompileException(reader.Path, pass.Line, "this pass has no HLSLPROGRAM");
            foreach (CodeBlock include in scope.Includes)
                if (include.Cg == program.Cg)
                    pass.Code.Add(include);
            pass.Code.Add(program);
            pass.Tags = scope.Tags;
            pass.State = scope.State;
            pass.Available = scope.Available;
            subShader.Passes.Add(pass);
        }

        // ---- properties

        void ReadProperties()
        {
            reader.Expect('{');
            while (!reader.TryReadSymbol('}'))
            {
                while (reader.IsSymbol('['))
                    reader.ReadBrackets();      // HDR, Toggle ... concern the inspector
                if (!reader.IsSymbol('}'))
                    shader.Properties.Add(ReadProperty());
            }
        }

        ShaderProperty ReadProperty()
        {
            var property = new ShaderProperty { Name = reader.ReadWord("a property's name") };
            reader.Expect('(');
            property.Description = reader.ReadText();
            reader.Expect(',');
            string type = reader.ReadWord("a property's type");
            switch (type.ToLowerInvariant())
            {
                case "float": property.Kind = ShaderPropertyKind.Float; break;
                case "int":
                case "integer": property.Kind = ShaderPropertyKind.Int; break;
                case "color": property.Kind = ShaderPropertyKind.Color; break;
                case "vector": property.Kind = ShaderPropertyKind.Vector; break;
                case "2d":
                case "rect":
                case "any": property.Kind = ShaderPropertyKind.Texture2D; break;
                case "3d": property.Kind = ShaderPropertyKind.Texture3D; break;
                case "cube": property.Kind = ShaderPropertyKind.TextureCube; break;
                case "2darray": property.Kind = ShaderPropertyKind.Texture2DArray; break;
                case "range":
                    property.Kind = ShaderPropertyKind.Range;
                    reader.Expect('(');
                    reader.ReadNumber();
                    reader.Expect(',');
                    reader.ReadNumber();
                    reader.Expect(')');
                    break;
                default:
                    throw reader.Error($"'{type}' is not a type of a property");
            }
            reader.Expect(')');
            reader.Expect('=');
            ReadDefault(property);
            return property;
        }

        void ReadDefault(ShaderProperty property)
        {
            if (property.Kind >= ShaderPropertyKind.Texture2D)
            {
                property.DefaultTexture = reader.ReadText();
                if (reader.IsSymbol('{'))
                    reader.SkipBraces();
            }
            else if (property.Kind == ShaderPropertyKind.Color || property.Kind == ShaderPropertyKind.Vector)
            {
                var values = new List<float>();
                reader.Expect('(');
                do
                    values.Add(reader.ReadNumber());
                while (reader.TryReadSymbol(','));
                reader.Expect(')');
                if (values.Count < 3 || values.Count > 4)
                    throw reader.Error($"'{property.Name}' has {values.Count} components; a {property.Kind} takes 4");
                if (values.Count == 3)
                    values.Add(1);
                property.Default = values.ToArray();
            }
            else
                property.Default = new[] { reader.ReadNumber() };
        }
    }
}
