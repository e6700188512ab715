using System;
using System.Collections.Generic;
using System.Linq;
using Host.Check.Api;
using Host.UnityApi;

namespace Host.Check
{
    /// <summary>Which of the package's methods call which, and what they call of others.</summary>
    /// <remarks>
    /// A call of a virtual method or of an interface's reaches every override and implementation in the package. One of a delegate reaches
    /// all methods that are anywhere made one of its type; so does one of another's method that is given a delegate made beside it.
    /// </remarks>
    sealed class CallGraph
    {
        readonly PackageTypes types;
        readonly ILookup<string, PackageMethod> byName;
        readonly ILookup<string, PackageMethod> made;

        public CallGraph(PackageTypes types)
        {
            this.types = types;
            byName = types.All.SelectMany(type => type.Methods).ToLookup(method => method.ShortName);
            made = types.All.SelectMany(type => type.Methods).SelectMany(Made).ToLookup(pair => pair.Delegate.ToString(), pair => pair.Target);
        }

        /// <summary>"UnityEngine.Object.get_name", of whatever is not the package's.</summary>
        public IEnumerable<string> ForeignCalls(PackageMethod method) => Named(method).Where(call => types.Find(call.Method.Owner) == null)
            .Select(call => $"{call.Method.Owner.Key}.{call.Method.Name}");

        public IEnumerable<PackageMethod> Calls(PackageMethod method)
        {
            foreach (CompiledCall call in Named(method).Where(call => !call.IsPointer))
            {
                IEnumerable<PackageMethod> targets = call.Method.Name == "Invoke" ? made[call.Method.Owner.ToString()]
                    : types.Find(call.Method.Owner) == null && call.Method.Name != ".ctor" ? GivenTo(call, method)
                        : Enumerable.Empty<PackageMethod>();
                foreach (PackageMethod target in targets.Concat(Targets(call)))
                    yield return target;
            }
        }

        IEnumerable<PackageMethod> GivenTo(CompiledCall call, PackageMethod caller) => Made(caller)
            .Where(pair => call.Method.Parameters.Any(parameter => parameter.Key == pair.Delegate.Key)).Select(pair => pair.Target);

        static IEnumerable<CompiledCall> Named(PackageMethod method) => method.Type.Assembly.Calls(method.Definition);

        // The method itself, and what overrides or implements it: methods of its name and as many parameters in heirs.
        IEnumerable<PackageMethod> Targets(CompiledCall call)
        {
            PackageType owner = types.Find(call.Method.Owner);
            foreach (PackageMethod candidate in byName[call.Method.Name])
            {
                if (candidate.Member.Parameters.Count != call.Method.Parameters.Count || candidate.Member.Arity != call.Method.Arity)
                    continue;
                bool isIt = owner != null && candidate.Type == owner && Same(candidate, call);
                bool isHeirs = candidate.IsVirtual && (owner != null ? candidate.Type != owner : true)
                    && types.DerivesFrom(candidate.Type, call.Method.Owner) && (candidate.Type.Definition.GetGenericParameters().Count > 0
                        || call.Method.Owner.Arguments.Count > 0 || Same(candidate, call));
                if (isIt || isHeirs)
                    yield return candidate;
            }
        }

        static bool Same(PackageMethod candidate, CompiledCall call) =>
            candidate.Member.Parameters.Select(type => type.ToString()).SequenceEqual(call.Method.Parameters.Select(type => type.ToString()))
            && candidate.Member.IsStatic == call.Method.IsStatic;

        // Which methods the code makes delegates of, each with the delegate's type: their pointer is loaded just before.
        IEnumerable<(ApiTypeName Delegate, PackageMethod Target)> Made(PackageMethod method)
        {
            CompiledCall pointer = null;
            foreach (CompiledCall call in Named(method))
            {
                if (pointer != null && call.Method.Name == ".ctor")
                    foreach (PackageMethod target in Targets(pointer))
                        yield return (call.Method.Owner, target);
                pointer = call.IsPointer ? call : null;
            }
        }
    }
}
