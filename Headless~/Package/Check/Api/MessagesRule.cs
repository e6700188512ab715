using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Reflection.Metadata;
using Host.UnityApi;

namespace Host.Check.Api
{
    /// <summary>
    /// A method with the name of a message has the message's form, on a class that Unity sends it to: else Unity does not call it, or calls what
    /// was not meant for it. A class does not hide the same message of a class that it derives from, which Unity then does not call.
    /// </summary>
    sealed class MessagesRule : Rule
    {
        readonly IReadOnlyList<string> names;

        public MessagesRule(IReadOnlyList<string> assemblies = null) => names = assemblies ?? PackageAssemblies.Package;

        public override string Name => "API: what has the name of one of Unity's messages has its form";

        public override Findings Examine(PackageTree package)
        {
            var findings = new Findings();
            int methods = 0;
            using var types = new PackageTypes(package, names, findings);
            foreach (PackageType type in types.All)
                if (Receives(types, type) is { Count: > 0 } received)
                    foreach (MethodDefinition method in MethodsOf(type))
                    {
                        methods++;
                        if (Complaint(types, type, method, received) is { } complaint)
                            findings.Fault($"{type.Assembly.Name}.dll: {type}.{type.Text(method.Name)} {complaint}");
                    }
            findings.Looked = $"{methods} methods, {UnityMessages.All.Count} messages";
            return findings;
        }

        // Messages that Unity sends to the heirs of a class, by its lineage in the lists.
        static List<UnityMessage> Receives(PackageTypes types, PackageType type)
        {
            if (types.ForeignBase(type) is not { } parent)
                return new List<UnityMessage>();
            HashSet<string> lineage = UnityCatalogs.All.Where(unity => unity.Find(parent.Key) != null)
                .SelectMany(unity => unity.Lineage(unity.Find(parent.Key))).Select(inherited => inherited.Type.Key).ToHashSet();
            return UnityMessages.All.Where(message => lineage.Contains(message.Receiver)).ToList();
        }

        static IEnumerable<MethodDefinition> MethodsOf(PackageType type) => type.Definition.GetMethods()
            .Select(type.Assembly.Metadata.GetMethodDefinition)
            .Where(method => (method.Attributes & MethodAttributes.SpecialName) == 0);

        /// <summary>Null: there is nothing to say of the method.</summary>
        static string Complaint(PackageTypes types, PackageType type, MethodDefinition method, List<UnityMessage> received)
        {
            string name = type.Text(method.Name);
            CompiledMember member = type.Assembly.Member(type.Name, method);
            List<UnityMessage> own = received.Where(message => message.Name == name).ToList();
            if (own.Count > 0 && !own.Any(message => Fits(message, member)))
                return $"has the name of a message of {own[0].Receiver}, but not its form ({string.Join("; ", own)}): rename it";
            if (own.Count == 0 && (method.Attributes & MethodAttributes.MemberAccessMask) != MethodAttributes.Public
                && UnityMessages.All.FirstOrDefault(message => message.Name == name && Fits(message, member)) is { } foreign)
                return $"is a message that Unity sends to a {foreign.Receiver} alone: rename it, or derive from that";
            // SceneView asks an editor's type for its method, which .NET answers without private ones of base classes.
            if (own.Any(message => message.Receiver == "UnityEditor.Editor")
                && (method.Attributes & MethodAttributes.MemberAccessMask) == MethodAttributes.Private
                && types.All.Any(heir => heir != type && types.Lineage(heir).Contains(type)))
                return "is private in a base class, where Unity does not find it: make it protected";
            bool overrides = (method.Attributes & (MethodAttributes.Virtual | MethodAttributes.NewSlot)) == MethodAttributes.Virtual;
            if (own.Count > 0 && !overrides && types.Lineage(type).Skip(1).FirstOrDefault(parent => MethodsOf(parent)
                .Any(inherited => parent.Text(inherited.Name) == name)) is { } hidden)
                return $"hides the message of {hidden}, which Unity then does not send: make one call the other, as a virtual method";
            return null;
        }

        static bool Fits(UnityMessage message, CompiledMember method) => method.IsStatic == message.IsStatic && method.Arity == 0
            && message.Returns.Contains(method.Returns.ToString())
            && (method.Parameters.Select(type => type.ToString()).SequenceEqual(message.Parameters)
                || message.Optional && method.Parameters.Count == 0);
    }
}
