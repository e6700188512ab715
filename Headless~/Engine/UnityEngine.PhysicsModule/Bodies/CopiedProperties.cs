using System.Linq;
using System.Reflection;

namespace UnityEngine.Headless
{
    /// <summary>Properties that Instantiate gives to the copy of a component of the physics: the values that its own properties hold.</summary>
    internal static class CopiedProperties
    {
        public static void Into(Component source, Component copy)
        {
            foreach (PropertyInfo property in source.GetType().GetProperties(BindingFlags.Instance | BindingFlags.Public)
                .Where(p => p.DeclaringType.Assembly == typeof(CopiedProperties).Assembly && HoldsAField(p)))
                property.SetValue(copy, property.GetValue(source));
            (source as ICopiesMore)?.CopyInto(copy);
        }

        static bool HoldsAField(PropertyInfo property)
            => property.GetMethod?.IsDefined(typeof(System.Runtime.CompilerServices.CompilerGeneratedAttribute)) == true
                && property.SetMethod != null;
    }

    /// <summary>A component with values that are more than a property's own field.</summary>
    internal interface ICopiesMore
    {
        void CopyInto(Component copy);
    }
}
