using System;

namespace Rill
{
    /// <summary>
    /// Marks a constant, an enum or a struct that shaders read too. `Headless~/rill generate` writes all that name a file into
    /// Shaders/Generated/[file].hlsl, which the shaders include: it is written once, here, with its unit in its summary.
    /// </summary>
    /// <remarks>
    /// The name Foo of a constant or an enum's member becomes kFoo. An int becomes a uint, as counts and indices are. Members of a struct keep their
    /// names. Those of a constant buffer get the shaders' form, _DomainSize for domainSize, and three with the scalar behind them become one
    /// 4-vector, since graphics APIs differ in where they put a vector of three.
    /// </remarks>
    [AttributeUsage(AttributeTargets.Field | AttributeTargets.Enum | AttributeTargets.Struct)]
    sealed class GenerateHlslAttribute : Attribute
    {
        /// <summary>Name of the file that is generated, without its extension.</summary>
        public readonly string File;

        /// <summary>Put before the names of constants: with "Foam", Alive becomes kFoamAlive.</summary>
        public string Prefix;

        /// <summary>Name of a struct in HLSL, where it differs.</summary>
        public string Name;

        /// <summary>Name of the constant buffer that a struct is uploaded to as it lies in memory.</summary>
        public string ConstantBuffer;

        /// <summary>Whether an int stays one.</summary>
        public bool Signed;

        public GenerateHlslAttribute(string file) => File = file;
    }
}
