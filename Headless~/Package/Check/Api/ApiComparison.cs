using System;
using System.Collections.Generic;
using System.Linq;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>Whether a compiled member is one that the lists have.</summary>
    static class ApiComparison
    {
        /// <summary>A listed name that is not full is matched from its end: nothing says what the file it stood in imported.</summary>
        public static bool Same(ApiTypeName listed, ApiTypeName compiled)
        {
            if (listed.Form != compiled.Form || listed.Rank != compiled.Rank)
                return false;
            if (listed.Form == ApiTypeForm.Parameter)
                return listed.Name == compiled.Name;
            if (listed.Form == ApiTypeForm.Named)
            {
                if (listed.Full ? listed.Key != compiled.Key : !EndsWith(compiled, listed))
                    return false;
            }
            int outer = compiled.Arguments.Count - listed.Arguments.Count;
            if (outer < 0 || outer > 0 && listed.Full)
                return false;
            return listed.Arguments.Select((argument, i) => Same(argument, compiled.Arguments[i + outer])).All(same => same);
        }

        static bool EndsWith(ApiTypeName compiled, ApiTypeName listed)
        {
            // Object in Unity's source means its own.
            if (listed.Path.Count == 1 && listed.Name == "Object")
                return compiled.Key == "UnityEngine.Object";
            return compiled.Key == listed.Key || compiled.Key.EndsWith("." + listed.Key, StringComparison.Ordinal);
        }

        static bool SameAll(IReadOnlyList<ApiParameter> listed, IEnumerable<ApiTypeName> compiled)
        {
            List<ApiTypeName> types = compiled.ToList();
            return listed.Count == types.Count && listed.Zip(types).All(pair => Same(pair.First.ByReference, pair.First.Type, pair.Second));
        }

        static bool Same(bool reference, ApiTypeName listed, ApiTypeName compiled)
        {
            if (reference != (compiled.Form == ApiTypeForm.Reference))
                return false;
            return Same(listed, reference ? compiled.Element : compiled);
        }

        /// <summary>Whether two methods of one name are the same to C#, which looks at parameters alone.</summary>
        public static bool SameParameters(ApiMember listed, CompiledMember compiled) =>
            listed.TypeParameters.Count == compiled.Arity && SameAll(listed.Parameters, compiled.Parameters);

        public static bool Fits(ApiMember listed, CompiledMember compiled)
        {
            if (listed.Kind != ApiKind.Constructor && compiled.IsStatic is { } isStatic && listed.Static != isStatic
                || listed.Name != compiled.SourceName)
                return false;
            if (compiled.IsField)
                return listed.Kind is ApiKind.Field or ApiKind.Value && (listed.Kind == ApiKind.Value || Same(listed.Type, compiled.Returns));
            IReadOnlyList<ApiTypeName> parameters = compiled.Parameters;
            bool isGetter = compiled.Name.StartsWith("get_"), isSetter = compiled.Name.StartsWith("set_");
            switch (listed.Kind)
            {
                case ApiKind.Property or ApiKind.Indexer when isGetter:
                    return listed.CanRead && SameAll(listed.Parameters, parameters) && Same(listed.ReturnsReference, listed.Type, compiled.Returns);
                case ApiKind.Property or ApiKind.Indexer when isSetter:
                    return listed.CanWrite && SameAll(listed.Parameters, parameters.SkipLast(1)) && Same(listed.Type, parameters[^1]);
                case ApiKind.Event:
                    return parameters.Count == 1 && Same(listed.Type, parameters[0]);
                case ApiKind.Constructor:
                    return SameAll(listed.Parameters, parameters);
                case ApiKind.Method or ApiKind.Operator or ApiKind.Conversion:
                    return SameParameters(listed, compiled) && Same(listed.ReturnsReference, listed.Type, compiled.Returns);
                default:
                    return false;
            }
        }

        /// <summary>A listed member with the arguments that its type is inherited with.</summary>
        public static ApiMember Inherited(ApiMember member, IReadOnlyList<ApiTypeName> arguments)
        {
            if (arguments == null || arguments.Count == 0)
                return member;
            ApiTypeName Substituted(ApiTypeName type) => type == null ? null : ApiCatalog.Substitute(type, arguments);
            return member.With(Substituted(member.Type),
                member.Parameters.Select(parameter => parameter with { Type = Substituted(parameter.Type) }).ToList());
        }
    }
}
