namespace Host.UnityApi
{
    /// <summary>One public or protected member (or a type itself) as the lists have it.</summary>
    /// <param name="Type">Full name as declared: "UnityEngine.Pool.ObjectPool&lt;T&gt;", nested types after a dot.</param>
    /// <param name="Signature">As declared, without attributes and bodies: "static void Destroy(Object obj, float t)", "int count { get }",
    /// "class : Behaviour", "value Structured".</param>
    /// <param name="Obsolete">Marked so in the versions of this line; where versions differ, there are two lines.</param>
    /// <param name="Versions">Bit i is set where <see cref="UnityApiLists.Versions"/>[i] has it. Packages (Unity.Mathematics, the Test
    /// Framework) count for every version.</param>
    sealed record ApiLine(string Type, string Signature, bool Obsolete, uint Versions)
    {
        public override string ToString() => $"{Type} | {Signature}{(Obsolete ? " [Obsolete]" : "")}";
    }
}
