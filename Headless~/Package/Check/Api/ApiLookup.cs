using System;
using System.Collections.Generic;
using System.Linq;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>Looks compiled members and types up in one version's lists.</summary>
    static class ApiLookup
    {
        /// <summary>Returns the fault of a reference in a version. Null: the member is there, and not obsolete; or its type is not, which is
        /// reported for the type.</summary>
        /// <param name="arguments">For a member whose signature names the arguments of its generic type; a reference names the parameters.</param>
        public static string Complaint(ApiCatalog unity, CompiledMember member, IReadOnlyList<ApiTypeName> arguments = null)
        {
            ApiType type = unity.Find(member.Owner.Key);
            if (type == null)
                return null;
            ApiMember found = Find(unity, type, member, arguments);
            if (found == null)
                return "has no such member" + Others(unity, type, member);
            return found.Obsolete && !type.WithinObsolete ? "has it as obsolete" : null;
        }

        public static string Complaint(ApiCatalog unity, ApiTypeName type)
        {
            ApiType found = unity.Find(type.Key);
            return found == null ? "has no such type" : found.WithinObsolete ? "has it as obsolete" : null;
        }

        /// <summary>The listed member of a type or of what it inherits from; one that is not obsolete before one that is.</summary>
        public static ApiMember Find(ApiCatalog unity, ApiType type, CompiledMember member, IReadOnlyList<ApiTypeName> arguments = null)
        {
            ApiMember obsolete = null;
            foreach ((ApiType owner, IReadOnlyList<ApiTypeName> inherited) in unity.Lineage(type))
            {
                if (member.Name == ".ctor" && owner != type)
                    break;
                foreach (ApiMember listed in owner.Named(member.SourceName))
                    if (ApiComparison.Fits(ApiComparison.Inherited(ApiComparison.Inherited(listed, inherited), arguments), member))
                    {
                        if (!listed.Obsolete)
                            return listed;
                        obsolete ??= listed;
                    }
            }
            return obsolete ?? Implied(type, member);
        }

        // Members that no declaration spells out.
        static ApiMember Implied(ApiType type, CompiledMember member)
        {
            bool implied = member.Name switch
            {
                // The lists hold no private constructor, so that a class without any may still have one.
                ".ctor" when type.Kind == ApiKind.Class => member.Parameters.Count == 0 && !type.Named(".ctor").Any(),
                ".ctor" when type.Kind == ApiKind.Struct => member.Parameters.Count == 0,
                ".ctor" when type.Kind == ApiKind.Delegate => true,
                "Invoke" when type.Kind == ApiKind.Delegate => ApiComparison.Fits(type.Declaration.With(ApiKind.Method, "Invoke"), member),
                "ToString" or "GetHashCode" => member.Parameters.Count == 0 && member.Arity == 0 && member.IsStatic != true,
                "Equals" => member.Parameters.Count == 1 && member.Parameters[0].Key == "System.Object" && member.IsStatic != true,
                _ => false,
            };
            return implied ? type.Declaration : null;
        }

        static string Others(ApiCatalog unity, ApiType type, CompiledMember member)
        {
            string[] others = unity.Lineage(type).SelectMany(inherited => inherited.Type.Named(member.SourceName))
                .Select(listed => listed.Line.Signature).Distinct().Take(3).ToArray();
            return others.Length == 0 ? "" : $" (but {string.Join("; ", others)})";
        }
    }
}
