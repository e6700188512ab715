using System;
using System.Collections.Generic;
using System.Linq;

namespace Host.UnityApi
{
    /// <summary>The types of one Unity version, with names in signatures resolved as far as the lists reach.</summary>
    sealed class ApiCatalog
    {
        // Names in files of Unity's for types that the lists know under another name.
        static readonly Dictionary<string, string> Aliases = new() { ["UnityObject"] = "UnityEngine.Object", ["UObject"] = "UnityEngine.Object" };

        readonly Dictionary<string, ApiType> types = new(StringComparer.Ordinal);
        // Last parts of all types' keys: most names that are asked for are .NET's.
        readonly HashSet<string> names = new(StringComparer.Ordinal);
        readonly Dictionary<(ApiType, string), ApiType> lookups = new();
        readonly List<string> unreadable = new();

        /// <summary>"2022.3".</summary>
        public string Version { get; }
        public IReadOnlyCollection<ApiType> Types => types.Values;
        /// <summary>Lines that could not be parsed, each with the reason. Their members are in no type.</summary>
        public IReadOnlyList<string> Unreadable => unreadable;
        public int MemberCount { get; private set; }

        readonly string only;       // "." for all

        /// <summary>Whether it has a say about what begins with the full name of a type.</summary>
        public bool IsFor(string what) => only == "." || what.StartsWith(only, StringComparison.Ordinal);

        /// <param name="more">Packages whose types this version has too, or null.</param>
        /// <param name="only">A package, "Unity.Mathematics", with its version: it is for types of that namespace alone. Null: for all.</param>
        public ApiCatalog(UnityApiLists lists, string version, UnityApiLists more = null, (string Namespace, string Version)? only = null)
        {
            Version = only == null ? version : $"{version} with {only.Value.Namespace} {only.Value.Version}";
            this.only = only?.Namespace + ".";
            var members = new List<(ApiType type, ApiMember member)>();
            foreach (IGrouping<string, ApiLine> group in (more == null ? lists.In(version) : lists.In(version).Concat(more.In(version)))
                .GroupBy(line => line.Type))
            {
                ApiType type = Declare(group.Key);
                foreach (ApiLine line in group)
                    try
                    {
                        members.Add((type, SignatureParser.Parse(line)));
                    }
                    catch (FormatException problem)
                    {
                        unreadable.Add(problem.Message);
                    }
            }
            foreach (ApiType type in types.Values)
            {
                type.Outer = types.GetValueOrDefault(Around(type.Key));
                names.Add(Last(type.Key));
            }

            // Bases first: a name in a signature can be a type nested in a base.
            foreach ((ApiType type, ApiMember member) in members)
                if (member.IsType)
                    AddDeclaration(type, member);
            foreach (ApiType type in types.Values)
                if (type.Declaration == null)
                    unreadable.Add($"{type.Name}: no line says what kind of type it is");
            lookups.Clear();
            foreach ((ApiType type, ApiMember member) in members)
                if (!member.IsType)
                    type.Members.Add(Resolve(member, type));
                else if (member.Kind == ApiKind.Delegate)
                    type.Declaration = Resolve(member, type);
            MemberCount = members.Count(m => !m.member.IsType);
        }

        public ApiType Find(string key) => types.GetValueOrDefault(key);

        /// <summary>The types that a type inherits from, itself first, each with the arguments that it is inherited with (in terms of the
        /// first type's parameters). What no list holds is left out.</summary>
        public IEnumerable<(ApiType Type, IReadOnlyList<ApiTypeName> Arguments)> Lineage(ApiType type)
        {
            var seen = new HashSet<string>();
            var next = new Queue<(ApiType, IReadOnlyList<ApiTypeName>)>();
            next.Enqueue((type, type.TypeParameters.Select((_, i) => ApiTypeName.Parameter("!" + i)).ToList()));
            while (next.Count > 0)
            {
                (ApiType current, IReadOnlyList<ApiTypeName> arguments) = next.Dequeue();
                if (!seen.Add(current.Key))
                    continue;
                yield return (current, arguments);
                foreach (ApiTypeName parent in current.Bases)
                    if (parent.Full && Find(parent.Key) is { } found)
                        next.Enqueue((found, parent.Arguments.Select(argument => Substitute(argument, arguments)).ToList()));
            }
        }

        /// <summary>With a type's arguments instead of its parameters.</summary>
        public static ApiTypeName Substitute(ApiTypeName type, IReadOnlyList<ApiTypeName> arguments) => type.Map(part =>
            part.Form == ApiTypeForm.Parameter && part.Name[0] == '!' && part.Name[1] != '!'
            && int.TryParse(part.Name.AsSpan(1), out int index) && index < arguments.Count ? arguments[index] : part);

        ApiType Declare(string name)
        {
            ApiTypeName parsed = SignatureParser.ParseType(name);
            if (types.TryGetValue(parsed.Key, out ApiType type))
                return type;
            type = new ApiType { Key = parsed.Key, Name = name, TypeParameters = parsed.Arguments.Select(argument => argument.Name).ToList() };
            types.Add(type.Key, type);
            return type;
        }

        void AddDeclaration(ApiType type, ApiMember member)
        {
            type.Declaration = member;
            type.Kind = member.Kind;
            type.Obsolete |= member.Obsolete;
            type.Protected |= member.Protected;
            foreach (ApiTypeName parent in member.Bases)
                type.Bases.Add(InEngine(Resolve(parent, type, Array.Empty<string>())));
        }

        // The Editor's files import the engine's namespace, which the lists do not say.
        ApiTypeName InEngine(ApiTypeName name) => !name.Full && Find("UnityEngine." + name.Key) is { } found
            ? ApiTypeName.Named(found.Key.Split('.'), name.Arguments) : name;

        ApiMember Resolve(ApiMember member, ApiType type)
        {
            IReadOnlyList<string> own = member.TypeParameters;
            if (member.Type != null)
                member.Type = Resolve(member.Type, type, own);
            member.Parameters = member.Parameters.Select(parameter => parameter with { Type = Resolve(parameter.Type, type, own) }).ToList();
            return member;
        }

        ApiTypeName Resolve(ApiTypeName name, ApiType type, IReadOnlyList<string> own) => name.Map(part =>
        {
            if (part.IsNullable && !IsValue(part.Element))
                return part.Element;
            if (part.Form != ApiTypeForm.Named || part.Full)
                return part;
            if (part.Path.Count == 1 && part.Arguments.Count == 0)
            {
                for (int index = 0; index < own.Count; index++)
                    if (own[index] == part.Name)
                        return ApiTypeName.Parameter("!!" + index);
                for (int index = type.TypeParameters.Count - 1; index >= 0; index--)
                    if (type.TypeParameters[index] == part.Name)
                        return ApiTypeName.Parameter("!" + index);
            }
            ApiType found = Lookup(part.Key, type);
            return found == null ? part : ApiTypeName.Named(found.Key.Split('.'), WithOuter(part.Arguments, found));
        });

        // "CommandBuffer?" is an annotation, "Vector3?" another type.
        bool IsValue(ApiTypeName type)
        {
            if (type.Form != ApiTypeForm.Named || type.Key is "System.String" or "System.Object" or "System.Array" or "System.Type")
                return false;
            return !type.Full || Find(type.Key) is not { Kind: ApiKind.Class or ApiKind.Interface or ApiKind.Delegate };
        }

        // Inside of a generic type its nested types are named without its parameters.
        static IReadOnlyList<ApiTypeName> WithOuter(IReadOnlyList<ApiTypeName> arguments, ApiType type)
        {
            int missing = type.TypeParameters.Count - arguments.Count;
            return missing <= 0 ? arguments : Enumerable.Range(0, missing).Select(i => ApiTypeName.Parameter("!" + i)).Concat(arguments).ToList();
        }

        ApiType Lookup(string name, ApiType type)
        {
            if (!names.Contains(Last(name)) && !Aliases.ContainsKey(name))
                return null;
            if (!lookups.TryGetValue((type, name), out ApiType found))
                lookups.Add((type, name), found = LookupOutwards(name, type));
            return found;
        }

        // Looks a name up like C#: nested types of the type and its bases, then outwards; then the namespaces around.
        ApiType LookupOutwards(string name, ApiType type)
        {
            for (ApiType scope = type; scope != null; scope = scope.Outer)
            {
                if (Last(scope.Key) == name)
                    return scope;
                foreach ((ApiType inherited, _) in Lineage(scope))
                    if (types.TryGetValue(inherited.Key + "." + name, out ApiType nested))
                        return nested;
            }
            for (string space = Around(type.Key); space.Length > 0; space = Around(space))
                if (types.TryGetValue(space + "." + name, out ApiType found))
                    return found;
            return types.GetValueOrDefault(name) ?? (Aliases.TryGetValue(name, out string meant) ? types.GetValueOrDefault(meant) : null);
        }

        static string Around(string key) => key.LastIndexOf('.') is var dot and > 0 ? key.Substring(0, dot) : "";
        static string Last(string key) => key.Substring(key.LastIndexOf('.') + 1);
    }
}
