using System;
using System.Collections.Generic;
using UnityEngine.Headless;

namespace Host.Shaders
{
    /// <summary>A number, or the name of the property that holds it.</summary>
    readonly struct StateValue
    {
        readonly float number;
        readonly string property;

        public StateValue(float number, string property = null)
        {
            this.number = number;
            this.property = property;
        }

        public float Resolve(Func<string, float> properties) => property == null ? number : properties(property);
        public int ResolveInt(Func<string, float> properties) => (int)Math.Round(Resolve(properties));
    }

    /// <summary>
    /// Cull, depth and blend state as ShaderLab writes it. Values are Unity's enumerations (CullMode, CompareFunction,
    /// BlendMode, BlendOp, ColorWriteMask), since a property holds those.
    /// </summary>
    sealed class RenderState
    {
        static readonly string[] CullModes = { "Off", "Front", "Back" };
        internal static readonly string[] Compares = { "Disabled", "Never", "Less", "Equal", "LEqual", "Greater", "NotEqual", "GEqual", "Always" };
        static readonly string[] Factors = { "Zero", "One", "DstColor", "SrcColor", "OneMinusDstColor", "SrcAlpha", "OneMinusSrcColor",
            "DstAlpha", "OneMinusDstAlpha", "SrcAlphaSaturate", "OneMinusSrcAlpha" };
        static readonly string[] Operations = { "Add", "Sub", "RevSub", "Min", "Max" };
        static readonly string[] Switch = { "Off", "On" };

        static readonly DeviceBlend[] DeviceFactors =
        {
            DeviceBlend.Zero, DeviceBlend.One, DeviceBlend.DstColor, DeviceBlend.SrcColor, DeviceBlend.OneMinusDstColor, DeviceBlend.SrcAlpha,
            DeviceBlend.OneMinusSrcColor, DeviceBlend.DstAlpha, DeviceBlend.OneMinusDstAlpha, DeviceBlend.SrcAlphaSaturate,
                DeviceBlend.OneMinusSrcAlpha,
        };

        // By CompareFunction. ShaderLab thinks of depth as growing with distance; the depth buffer is reversed, so "less" is greater there.
        static readonly DeviceCompare[] ReversedCompares =
        {
            DeviceCompare.Always, DeviceCompare.Never, DeviceCompare.Greater, DeviceCompare.Equal, DeviceCompare.GreaterEqual,
            DeviceCompare.Less, DeviceCompare.NotEqual, DeviceCompare.LessEqual, DeviceCompare.Always,
        };

        StateValue cull = new StateValue(2), zWrite = new StateValue(1), zTest = new StateValue(4), colorMask = new StateValue(15);
        StateValue offsetFactor, offsetUnits;
        bool blend;
        StencilState stencil;
        StateValue srcColor = new StateValue(1), dstColor, srcAlpha = new StateValue(1), dstAlpha, colorOp, alphaOp;

        public RenderState Copy() => (RenderState)MemberwiseClone();

        /// <summary>State for the options alpha and decal of a surface shader.</summary>
        public RenderState With(SurfaceBlend mode)
        {
            RenderState state = Copy();
            if (mode == SurfaceBlend.Opaque)
                return state;
            StateValue one = new StateValue(1), alpha = new StateValue(5), oneMinusAlpha = new StateValue(10);
            state.blend = true;
            state.srcColor = state.srcAlpha = mode == SurfaceBlend.Premultiplied || mode == SurfaceBlend.DecalAdd ? one : alpha;
            state.dstColor = state.dstAlpha = mode == SurfaceBlend.DecalAdd ? one : oneMinusAlpha;
            state.zWrite = new StateValue(0);
            return state;
        }

        /// <summary>State of the pass that casts the shadow of a surface shader: depth alone.</summary>
        public RenderState ForCaster()
        {
            RenderState state = Copy();
            state.blend = false;
            (state.zWrite, state.zTest, state.colorMask) = (new StateValue(1), new StateValue(4), new StateValue(0));
            return state;
        }

        /// <summary>Reads one command when the reader stands at one. Adds to the notes what this host leaves out.</summary>
        public bool TryRead(ShaderLabReader reader, List<string> notes)
        {
            if (reader.TryReadWord("Cull"))
                cull = Choice(reader, CullModes);
            else if (reader.TryReadWord("ZWrite"))
                zWrite = Choice(reader, Switch);
            else if (reader.TryReadWord("ZTest"))
                zTest = reader.TryReadWord("Off") ? new StateValue(8) : Choice(reader, Compares);
            else if (reader.TryReadWord("Offset"))
            {
                offsetFactor = Number(reader);
                reader.Expect(',');
                offsetUnits = Number(reader);
            }
            else if (reader.TryReadWord("ColorMask"))
                ReadColorMask(reader, notes);
            else if (reader.TryReadWord("BlendOp"))
                ReadBlendOp(reader, notes);
            else if (reader.TryReadWord("Blend"))
                ReadBlend(reader, notes);
            else if (reader.TryReadWord("Stencil"))
            {
                stencil = StencilState.Read(reader, Choice, Number, notes);
            }
            else if (reader.TryReadWord("Fog"))
                reader.SkipBraces();    // of the fixed-function pipeline, without meaning beside a program
            else if (reader.IsWord("AlphaToMask") || reader.IsWord("ZClip") || reader.IsWord("Conservative") || reader.IsWord("Lighting"))
            {
                string command = reader.ReadWord("a command");
                string value = reader.IsSymbol('[') ? reader.ReadBrackets() : reader.ReadWord("On or Off");
                bool usual = command.Equals("ZClip", StringComparison.OrdinalIgnoreCase)
                    ? value.Equals("True", StringComparison.OrdinalIgnoreCase) : value.Equals("Off", StringComparison.OrdinalIgnoreCase)
                    || value.Equals("False", StringComparison.OrdinalIgnoreCase);
                if (!usual)
                    notes.Add($"line {reader.Line}: {command} {value} is left out");
            }
            else
                return false;
            return true;
        }

        static StateValue Choice(ShaderLabReader reader, string[] names)
        {
            if (reader.IsSymbol('['))
                return new StateValue(0, reader.ReadBrackets());
            int index = reader.Kind == LabTokenKind.Word ? Array.FindIndex(names, n => reader.IsWord(n)) : -1;
            if (index < 0 && ReferenceEquals(names, Switch))
                index = reader.IsWord("True") ? 1 : reader.IsWord("False") ? 0 : -1;
            if (index < 0)
                throw reader.Unexpected("one of " + string.Join(", ", names));
            reader.Next();
            return new StateValue(index);
        }

        static StateValue Number(ShaderLabReader reader) => reader.IsSymbol('[') ? new StateValue(0, reader.ReadBrackets())
            : new StateValue(reader.ReadNumber());

        // A leading number names one render target; here all of them have one state.
        static bool TakesOtherTarget(ShaderLabReader reader, List<string> notes)
        {
            if (reader.Kind != LabTokenKind.Number)
                return false;
            int target = (int)reader.ReadNumber();
            if (target > 0)
                notes.Add($"line {reader.Line}: state of render target {target} alone is left out");
            return target > 0;
        }

        void ReadBlend(ShaderLabReader reader, List<string> notes)
        {
            bool other = TakesOtherTarget(reader, notes);
            if (reader.TryReadWord("Off"))
            {
                blend = blend && other;
                return;
            }
            StateValue source = Choice(reader, Factors), target = Choice(reader, Factors), sourceAlpha = source, targetAlpha = target;
            if (reader.TryReadSymbol(','))
            {
                sourceAlpha = Choice(reader, Factors);
                targetAlpha = Choice(reader, Factors);
            }
            if (other)
                return;
            blend = true;
            (srcColor, dstColor, srcAlpha, dstAlpha) = (source, target, sourceAlpha, targetAlpha);
        }

        void ReadBlendOp(ShaderLabReader reader, List<string> notes)
        {
            bool other = TakesOtherTarget(reader, notes);
            StateValue color = Choice(reader, Operations);
            StateValue alpha = reader.TryReadSymbol(',') ? Choice(reader, Operations) : color;
            if (!other)
                (colorOp, alphaOp) = (color, alpha);
        }

        void ReadColorMask(ShaderLabReader reader, List<string> notes)
        {
            StateValue mask;
            if (reader.IsSymbol('['))
                mask = new StateValue(0, reader.ReadBrackets());
            else if (reader.Kind == LabTokenKind.Number)
                mask = new StateValue(reader.ReadNumber());
            else
            {
                int bits = 0;
                foreach (char channel in reader.ReadWord("channels such as RGB").ToUpperInvariant())
                {
                    int bit = "ABGR".IndexOf(channel);
                    if (bit < 0)
                        throw reader.Error($"'{channel}' is not a channel; ColorMask takes R, G, B, A or 0");
                    bits |= 1 << bit;
                }
                mask = new StateValue(bits);
            }
            if (!TakesOtherTarget(reader, notes))
                colorMask = mask;
        }

        /// <summary>Converts to the device's state: compares for a reversed depth buffer, an offset that pushes away from the viewer.</summary>
        public DeviceRasterState Resolve(Func<string, float> properties)
        {
            int compare = zTest.ResolveInt(properties);
            return new DeviceRasterState
            {
                Cull = (DeviceCull)cull.ResolveInt(properties),
                DepthWrite = zWrite.ResolveInt(properties) != 0,
                DepthTest = ReversedCompares[Math.Clamp(compare, 0, ReversedCompares.Length - 1)],
                Blend = blend,
                SrcColor = Factor(srcColor, properties),
                DstColor = Factor(dstColor, properties),
                SrcAlpha = Factor(srcAlpha, properties),
                DstAlpha = Factor(dstAlpha, properties),
                ColorOp = (DeviceBlendOp)Math.Clamp(colorOp.ResolveInt(properties), 0, 4),
                AlphaOp = (DeviceBlendOp)Math.Clamp(alphaOp.ResolveInt(properties), 0, 4),
                ColorMask = colorMask.ResolveInt(properties) & 15,
                DepthBiasFactor = 0 - offsetFactor.Resolve(properties),
                DepthBiasUnits = 0 - offsetUnits.Resolve(properties),
                Stencil = stencil?.Resolve(properties) ?? default,
            };
        }

        static DeviceBlend Factor(StateValue value, Func<string, float> properties)
            => DeviceFactors[Math.Clamp(value.ResolveInt(properties), 0, DeviceFactors.Length - 1)];
    }
}
