using System;
using System.Runtime.CompilerServices;

namespace UnityEngine.Headless
{
    /// <summary>Bindings that a compiled program needs, with names turned into property ids once.</summary>
    internal sealed class ProgramLayout
    {
        internal struct Field
        {
            public int Id;
            /// <summary>For X_TexelSize the id of texture X, otherwise -1.</summary>
            public int TexelSizeOf;
            /// <summary>For X_ST the id of texture X, otherwise -1.</summary>
            public int ScaleOffsetOf;
            public ConstantField Layout;
        }

        internal struct Slot
        {
            public ShaderResource Resource;
            public int Id;
            /// <summary>For a sampler that takes a texture's own state: that texture's id, otherwise -1.</summary>
            public int SamplerOf;
            /// <summary>Slots of the textures that are read through a sampler.</summary>
            public int[] Sampled;
            public Field[] Fields;
            /// <summary>A buffer of UNITY_INSTANCING_BUFFER_START: an array has an element for each instance.</summary>
            public bool Instanced;
            /// <summary>Filled again for every dispatch or draw; the device copies it.</summary>
            public byte[] Constants;
        }

        static readonly ConditionalWeakTable<ShaderProgram, ProgramLayout> layouts = new ConditionalWeakTable<ShaderProgram, ProgramLayout>();

        public readonly ShaderProgram Program;
        public readonly Slot[] Slots;
        ApiLimits judgedBy;
        string excess;

        ProgramLayout(ShaderProgram program)
        {
            Program = program;
            Slots = new Slot[program.Resources.Length];
            for (int i = 0; i < Slots.Length; i++)
                Slots[i] = SlotOf(program.Resources[i]);
            for (int i = 0; i < Slots.Length; i++)
                if (program.Resources[i].SampledTextures is string[] names)
                    Slots[i].Sampled = Array.ConvertAll(names, name => Array.FindIndex(program.Resources, r => r.Name == name));
        }

        /// <summary>Why the player's limits do not hold the program; null when they do. Found once.</summary>
        public string Excess
        {
            get
            {
                if (judgedBy != Player.Limits)
                {
                    judgedBy = Player.Limits;
                    excess = judgedBy.WhyNot(new ProgramNeeds(Program));
                }
                return excess;
            }
        }

        public static ProgramLayout Of(ShaderProgram program) => layouts.GetValue(program, p => new ProgramLayout(p));

        static Slot SlotOf(ShaderResource resource)
        {
            var slot = new Slot { Resource = resource, Id = PropertyNames.ToId(resource.Name), SamplerOf = -1 };
            if (!string.IsNullOrEmpty(resource.SamplerOf))
                slot.SamplerOf = PropertyNames.ToId(resource.SamplerOf);
            if (resource.Constants == null)
                return slot;

            // The matrices come for the batch at hand, the properties for the whole call.
            slot.Instanced = resource.Name.StartsWith("UnityInstancing_", StringComparison.Ordinal) && resource.Name != "UnityInstancing_PerDraw0";
            slot.Constants = new byte[Math.Max(16, (resource.Constants.Bytes + 15) / 16 * 16)];
            slot.Fields = new Field[resource.Constants.Fields.Length];
            for (int f = 0; f < slot.Fields.Length; f++)
            {
                ConstantField field = resource.Constants.Fields[f];
                slot.Fields[f] = new Field
                {
                    Id = PropertyNames.ToId(field.Name), Layout = field,
                    TexelSizeOf = BaseId(field.Name, "_TexelSize"), ScaleOffsetOf = BaseId(field.Name, "_ST"),
                };
            }
            return slot;
        }

        static int BaseId(string name, string suffix) =>
            name.EndsWith(suffix, StringComparison.Ordinal) ? PropertyNames.ToId(name.Substring(0, name.Length - suffix.Length)) : -1;
    }
}
