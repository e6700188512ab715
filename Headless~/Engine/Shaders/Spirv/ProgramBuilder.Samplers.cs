using System.Collections.Generic;
using System.Linq;

namespace Host.Shaders
{
    // Which textures each sampler is used with.
    sealed partial class ProgramBuilder
    {
        /// <summary>Names of textures by the name of a sampler.</summary>
        ILookup<string, string> SampledTextures()
        {
            var origins = new SampledOrigins(code);
            var names = variables.Where(IsResource).ToDictionary(variable => variable[1], variable => types.Name(variable[1]));
            return code.Where(i => i.Op == Op.SampledImage)
                .SelectMany(i => origins.Of(i[3]).SelectMany(sampler => origins.Of(i[2]).Select(texture => (sampler, texture))))
                .Where(pair => names.ContainsKey(pair.sampler) && names.ContainsKey(pair.texture)).Distinct()
                .ToLookup(pair => names[pair.sampler], pair => names[pair.texture]);
        }

        // The variables that a texture or a sampler may come from: by loads, copies, and what calls hand to functions.
        sealed class SampledOrigins
        {
            readonly ILookup<uint, uint> sources;

            public SampledOrigins(List<Instruction> code) => sources = Edges(code).ToLookup(edge => edge.to, edge => edge.from);

            public IEnumerable<uint> Of(uint id)
            {
                var seen = new HashSet<uint> { id };
                var open = new Queue<uint>(seen);
                while (open.Count > 0)
                {
                    uint next = open.Dequeue();
                    yield return next;
                    foreach (uint source in sources[next])
                        if (seen.Add(source))
                            open.Enqueue(source);
                }
            }

            static IEnumerable<(uint from, uint to)> Edges(List<Instruction> code)
            {
                var parameters = new Dictionary<uint, List<uint>>();
                uint function = 0;
                foreach (Instruction i in code)
                    if (i.Op == Op.Function)
                        parameters[function = i[1]] = new List<uint>();
                    else if (i.Op == Op.FunctionParameter)
                        parameters[function].Add(i[1]);
                foreach (Instruction i in code)
                    switch (i.Op)
                    {
                        case Op.Load:
                        case Op.CopyObject:
                        case Op.AccessChain:
                            yield return (i[2], i[1]);
                            break;
                        case Op.Store:
                        case Op.CopyMemory:
                            yield return (i[1], i[0]);
                            break;
                        case Op.FunctionCall:
                            for (int p = 0; p < parameters[i[2]].Count; p++)
                                yield return (i[3 + p], parameters[i[2]][p]);
                            break;
                    }
            }
        }
    }
}
