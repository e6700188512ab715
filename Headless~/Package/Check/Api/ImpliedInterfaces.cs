using System;
using System.Collections.Generic;
using System.Linq;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>Metadata names every interface of a type, declarations only those that do not follow from others: IEnumerable follows from
    /// IEnumerable&lt;T&gt;.</summary>
    static class ImpliedInterfaces
    {
        static readonly Dictionary<string, Type> known = typeof(object).Assembly.GetExportedTypes().Where(type => type.IsInterface)
            .ToDictionary(type => type.Name);

        public static bool Contains(IEnumerable<ApiTypeName> declared, ApiTypeName wanted) =>
            declared.Any(type => known.TryGetValue(type.Name, out Type found)
            && found.GetInterfaces().Any(inherited => inherited.Name == wanted.Name
            && (inherited.Namespace + "." + inherited.Name) == wanted.Key));
    }
}
